/// @file
/// The physics is compiled twice from the same sources, once with `Real` = float and
/// once with `Real` = double. Everything it defines lives in one of the two namespaces
/// below, so that one executable can hold both. A source that is compiled for one
/// precision sees that one as if it were `timestep` itself; all others name it.
/// Source: chapter 1.
#pragma once

namespace timestep {
#if defined(TIMESTEP_SINGLE)
#define TIMESTEP_PRECISION single_precision
inline namespace single_precision {}
namespace double_precision {}
#elif defined(TIMESTEP_DOUBLE)
#define TIMESTEP_PRECISION double_precision
namespace single_precision {}
inline namespace double_precision {}
#else
namespace single_precision {}
namespace double_precision {}
#endif
}  // namespace timestep

// Headers that name both precisions open these namespaces again without `inline`, as
// the language lets them; Clang warns of it
#if defined(__clang__)
#pragma clang diagnostic ignored "-Winline-namespace-reopened-noninline"
#endif
