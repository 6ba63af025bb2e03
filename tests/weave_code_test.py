"""Tests of docs/weave_code.py: excerpts of C++ by name."""
from __future__ import annotations

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs"))
sys.dont_write_bytecode = True
import weave_code  # noqa: E402
import weave_runs  # noqa: E402

SOURCE = '''#define BRACE {
namespace x {
/// Falls. // {
/// Slowly.
inline double fall(double t, const std::vector<int>& v = {}) noexcept {
  const char* s = "}";  // }
  if (t > 0) { return fall(t - 1); }
  return '{' + call(fall(2));
}
double fall_later(double);
/// A body.
struct Body : Base {
  Body() : x{1} { start(); }
  double x = 0;  ///< [m]
  int two() const { return 2; }
};
int Body::two(int) { return 2; }
int Body::two(long) { return 3; }
}
'''


class WeaveCodeTest(unittest.TestCase):
    def test_code_is_found_by_name(self) -> None:
        one = weave_code.symbol(SOURCE, "fall", struct=False, doc=True)
        self.assertTrue(one.startswith("/// Falls. // {\n/// Slowly.\ninline"))
        self.assertTrue(one.endswith("call(fall(2));\n}"))
        body = weave_code.symbol(SOURCE, "Body", struct=True, doc=False)
        self.assertTrue(body.startswith("struct Body : Base {") and body.endswith("};"))
        self.assertEqual(weave_code.symbol(SOURCE, "two", False, False),
                         "int two() const { return 2; }")
        second = weave_code.symbol(SOURCE, "Body::two#2", False, False)
        self.assertIn("return 3", second)
        self.assertEqual(weave_code.lines_between(SOURCE, "if .t", "return '"),
                         "if (t > 0) { return fall(t - 1); }\n"
                         "return '{' + call(fall(2));")
        for name in ("Body::two", "Body::two#3", "fall_later", "none"):
            with self.assertRaises(weave_runs.WeaveError):
                weave_code.symbol(SOURCE, name, False, False)


if __name__ == "__main__":
    unittest.main()
