"""Tests of the table of symbols that docs/weave_notation.py makes and checks."""
from __future__ import annotations

import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "docs"))
sys.dont_write_bytecode = True
import weave_notation  # noqa: E402
from weave_runs import WeaveError  # noqa: E402

HEADER = """/// @file
namespace fall {
/// Places x [m] and their rates v [m/s].
struct State {
  Real x, v;
  Real inverse_mass;  ///< [1/kg] is in the text, the inverse mass [1/kg]
};

/// (1.1) Weight of a mass m [kg]; drag k = c / 2 [kg/m].
inline Vec3 weight(Real m, const Vec3& g) {
  return m * g;
}
/// After a time t [s] of a step dt.
void step(State& state, Real t, Real dt);
}
"""
TEXT = r"""Not here: $q$.

```math
F = m g, \qquad \dot x_{n+1} = v \tag{1.1}
```

```math
\begin{aligned} F(\sinh s) &= e^{-\Delta t} \\
v_\text{max} &= \tfrac{1}{2} C_d \end{aligned} \tag{1.2}
```
"""


def row(symbol: str, unit: str = "1", *identifiers: str, **more: object) -> dict:
    return {"symbol": symbol, "meaning": f"the {symbol}", "unit": unit,
            "identifiers": [f"common/fall.hpp {name}" for name in identifiers], **more}


ROWS = [row("F", "N", equations=["1.1"]), row("m", "kg", "weight(m)"), row("g", "m/s²"),
        row("x", "m", "State::x"), row("v", "m/s", "fall::State::v"), row("s"),
        row("F(s)", equations=["1.2"]), row(r"\Delta t", "s", "step(dt)"), row("C_d")]


class NotationTest(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        self.page = self.root / "chapters/01-x/README.md"
        self.page.parent.mkdir(parents=True)
        (self.root / "common").mkdir()
        (self.root / "common/fall.hpp").write_text(HEADER)

    def table(self, rows: list[dict], known: tuple[str, ...] = ("e",)) -> str:
        (self.page.parent / "notation.json").write_text(
            json.dumps({"symbols": rows, "known": list(known)}))
        return weave_notation.table(self.page, TEXT, self.root)

    def fault(self, rows: list[dict], known: tuple[str, ...] = ("e",)) -> str:
        with self.assertRaises(WeaveError) as caught:
            self.table(rows, known)
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception)

    def test_symbols_of_a_formula(self) -> None:
        for tex, found in (
                (r"x_{n+1} = \frac{a}{2}", ["x_n+1", "a"]),
                (r"\Delta t^2 \cdot \omega_0", [r"\Deltat", r"\omega_0"]),
                (r"\hat n \dot{\bar x}", [r"\hatn", r"\barx"]),
                (r"\sinh s \bigl( \text{if } k_\text{max} \bigr)", ["s", "k_max"]),
                (r"2^{\lfloor \log_2 t \rfloor} \tag{1.2}", ["t"]),
                (r"a \\v", ["a", "v"])):
            names = [name for _, name in weave_notation.symbols(tex)]
            self.assertEqual(names, found, tex)

    def test_the_table_links_to_the_code_and_lists_equations(self) -> None:
        lines = self.table(ROWS).splitlines()
        self.assertEqual(len(lines), 2 + len(ROWS))
        self.assertIn("| $m$ | the m | kg | [`weight(m)`](../../common/fall.hpp) | 1.1 |",
                      lines)
        self.assertIn("| $v$ | the v | m/s | [`fall::State::v`](../../common/fall.hpp) "
                      "| 1.1–1.2 |", lines)
        self.assertIn("| $F(s)$ | the F(s) | 1 | – | 1.2 |", lines)

    def test_equations_in_short(self) -> None:
        tags = ["1.10", "1.3", "1.2", "1.1", "2.1", "1.10", ""]
        self.assertEqual(weave_notation.in_short(tags), "1.1–1.3, 1.10, 2.1")

    def test_a_symbol_without_a_row_is_named(self) -> None:
        self.assertIn("(1.1) has g, which has no row", self.fault(ROWS[:2] + ROWS[3:]))
        self.assertIn("(1.2) has F, which", self.fault(ROWS[:6] + ROWS[7:]))
        self.assertIn("(1.2) has C_d, which",
                      self.fault([*ROWS[:-1], row("C_l")]))
        self.assertIn("(1.2) has e, which", self.fault(ROWS, known=()))

    def test_a_row_without_a_formula_is_named(self) -> None:
        self.assertIn("q is in no formula", self.fault([*ROWS, row("q")]))
        self.assertIn("i is in no formula", self.fault(ROWS, known=("e", "i")))
        wrong = row("g", "m/s²", equations=["1.1", "1.2"])
        self.assertIn("g is not in (1.2)", self.fault([*ROWS, wrong]))

    def test_identifiers_must_exist(self) -> None:
        for name in ("lift", "State::y", "weight(q)", "Stat::x", "step(m)"):
            rows = [*ROWS, row("m", "kg", name)]
            self.assertIn(f"fall.hpp has no '{name}'", self.fault(rows))
        missing = {**row("m"), "identifiers": ["common/none.hpp m"]}
        self.assertIn("no file none.hpp", self.fault([*ROWS, missing]))

    def test_units_must_be_those_of_the_doc_comments(self) -> None:
        for symbol, unit, name, documented in (
                ("m", "g", "weight(m)", "kg"), ("x", "km", "State::x", "m"),
                ("v", "m", "State::v", "m/s"), ("s", "h", "step(t)", "s"),
                ("m", "kg", "State::inverse_mass", "1/kg")):
            said = self.fault([*ROWS, row(symbol, unit, name)])
            self.assertIn(f"{name} of fall.hpp is in [{documented}]", said)

    def test_a_unit_may_stand_behind_a_formula_but_not_behind_a_full_stop(self) -> None:
        units = weave_notation.documented_units
        self.assertEqual(units("drag k = c / 2 [kg/m]", "k"), {"kg/m"})
        self.assertEqual(units("the spring k. A time [s]", "k"), set())
        self.assertEqual(units("sum of the forces [N]", "force"), {"N"})
        self.assertEqual(units("a mass [kg]", "a"), set())

    def test_broken_files_are_one_line(self) -> None:
        file = self.page.parent / "notation.json"
        for text in ("{", "{}", '{"symbols": [{"symbol": "x"}]}', "[]",
                     '{"symbols": [{"symbol": "1", "meaning": "", "unit": "", '
                     '"identifiers": []}]}'):
            file.write_text(text)
            with self.assertRaisesRegex(WeaveError, "^notation.json[^\n]+$"):
                weave_notation.table(self.page, TEXT, self.root)
        file.unlink()
        with self.assertRaisesRegex(WeaveError, "no notation.json"):
            weave_notation.table(self.page, TEXT, self.root)


if __name__ == "__main__":
    unittest.main()
