"""Tests of bench/bench_table.py on a made-up report of Google Benchmark."""
from __future__ import annotations

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "bench"))
sys.dont_write_bytecode = True
import bench_table  # noqa: E402


def run(name: str, family: int, **rates: float) -> dict:
    return {"name": name, "family_index": family, **rates}


REPORT = {
    "context": {"compiler": "GNU 12", "Odeint": "Boost 1_74", "Bullet": "3.24"},
    "benchmarks": [
        run("kepler/rk4/alone", 7, items_per_second=20e6, energy_error=1e-8),
        run("kepler/rk4/whole", 6, items_per_second=10e6, energy_error=1e-8),
        run("kepler/runge_kutta4/Odeint", 8, items_per_second=16e6, energy_error=2e-8),
        run("kepler/runge_kutta4_classic/Odeint", 9, items_per_second=40e6,
            energy_error=3e-8),
        run("particles/rk4/whole/double/4096", 1, items_per_second=100e6),
        run("particles/rk4/swarm/double/4096", 2, items_per_second=200e6, kept=2),
        run("particles/rk4/swarm/double/4096", 2, items_per_second=900e6, kept=2),
        run("particles/rk4/swarm/double/4096", 2, items_per_second=400e6, kept=2),
        run("particles/rk4/by_hand/double/4096", 3, items_per_second=500e6),
        run("particles/rk4/swarm/double/1000000", 4, items_per_second=100e6,
            bytes_per_second=30e9, kept=2),
        run("bandwidth/triad/double/1000000/2", 5, bytes_per_second=40e9),
        run("particles/explicit_euler/whole/double/4096", 0, items_per_second=300e6),
        run("rotation/momentum/single/1000", 10, items_per_second=20e6),
        run("rotation/momentum/single/100000", 11, items_per_second=10e6),
        run("rotation/momentum/double/100000", 12, items_per_second=5e6),
        run("top/momentum/single", 13, attitude_error_1_s=math.pi / 180,
            energy_change=-0.25, flips=21, flips_energy_change=1e-3),
        run("top/momentum/double", 14, attitude_error_1_s=math.pi / 360, flips=22),
        run("rotation/Bullet_world/single/100000", 15, items_per_second=2.5e6),
        run("rotation/constant_omega/single/100000", 17, items_per_second=40e6),
        run("top/Bullet_world/single", 16, attitude_error_1_s=math.pi / 90, flips=3),
    ]}


class BenchTableTest(unittest.TestCase):
    def setUp(self) -> None:
        self.measured = bench_table.results(REPORT, "an abacus")
        self.tables = bench_table.Tables(self.measured)

    def row(self, part: str, index: int) -> dict[str, str]:
        cells = self.tables.rows(part)[index]
        return {heading: str(cell) for heading, cell in cells.items()}

    def test_medians_of_all_rounds_in_the_order_of_the_program(self) -> None:
        self.assertEqual(self.measured["machine"], "an abacus")
        self.assertEqual(self.measured["Odeint"], "Boost 1_74")
        self.assertEqual(self.measured["Bullet"], "3.24")
        self.assertNotIn("GSL", self.measured)
        self.assertEqual(self.measured["medians"]["particles/rk4/swarm/double/4096"],
                         {"million_per_second": 400, "ns": 2.5, "kept": 2})
        self.assertEqual(self.tables.methods, ["explicit_euler", "rk4"])

    def test_particles_as_ratios(self) -> None:
        row = self.row("particles", 1)
        self.assertEqual(row["method"], "`rk4`")
        self.assertEqual(row["in cache, whole [10⁶/s]"], "– / 100")
        self.assertEqual(row["time / by hand"], "– / 1.25")
        self.assertEqual(row["bandwidth / triad's"], "– / 0.75")
        self.assertEqual(row["bandwidth / update's"], "–")

    def test_the_faster_of_two_steppers_is_the_peer(self) -> None:
        row = self.row("kepler", 0)
        self.assertEqual(row["Odeint"], "`runge_kutta4_classic`")
        self.assertEqual(row["time / Odeint's"], "2.00")
        self.assertEqual(row["Odeint's energy error"], "3.0 × 10⁻⁸")

    def test_bodies_beside_those_of_the_same_precision(self) -> None:
        row = self.row("rotation", 0)
        self.assertEqual(row["method"], "`momentum`")
        self.assertEqual(row["1,000 bodies [ns]"], "50.0 / –")
        self.assertEqual(row["100,000 bodies [ns]"], "100.0 / 200.0")
        self.assertEqual(row["time / without gyroscopic term"], "4.00 / –")
        self.assertEqual(row["time / Bullet's world"], "0.25 / –")
        self.assertEqual(row["time / ODE's"], "–")
        self.assertEqual(self.row("rotation", 1)["time / Bullet's world"], "1.00 / –")

    def test_what_becomes_of_a_top_in_degrees(self) -> None:
        row = self.row("top", 0)
        self.assertEqual(row["attitude error, 1 s [°]"], "1 / 0.5")
        self.assertEqual(row["attitude error, 10 s [°]"], "–")
        self.assertEqual(row["energy, 100 s"], "−2.5 × 10⁻¹ / –")
        self.assertEqual(row["flips, 60 s"], "21 / 22")
        self.assertEqual(self.row("top", 1)["flips, 60 s"], "3 / –")

    def test_answers_to_random_pairs_say_how_many_are_wrong(self) -> None:
        self.measured["medians"] |= {
            "contacts/box_box/depth/sat/double": {"ns": 200.0, "wrong": 0},
            "contacts/box_box/depth/Bullet_boxes/single": {"ns": 160.0, "wrong": 22},
            "contacts/box_box/depth/sat/single": {"ns": 120.0, "wrong": 0},
            "contacts/sphere_box/distance/gjk_epa/double": {"ns": 400.0, "wrong": 0},
            "contacts/sphere_box/distance/gjk_epa_warm/double": {"ns": 100.0},
            "contacts/sphere_box/distance/Bullet/double": {"ns": 1600.0, "wrong": 1}}
        self.tables = bench_table.Tables(self.measured)
        row = self.row("contacts", 0)
        self.assertEqual((row["pairs"], row["asked for"]), ("`sphere_box`", "`distance`"))
        self.assertEqual(row["GJK and EPA"], "400")
        self.assertEqual(row["warm / cold"], "0.25")
        self.assertEqual(row["Bullet, GJK"], "1,600 (1)")
        self.assertEqual(row["GJK and EPA / Bullet's"], "– / 0.25")
        self.assertEqual(row["FCL"], "–")
        row = self.row("contacts", 1)
        self.assertEqual(row["Bullet, boxes"], "160 (22)")
        self.assertEqual(row["SAT / Bullet's boxes"], "0.75 / 1.25")
        text = bench_table.comma_separated(self.tables.rows("contacts"))
        self.assertIn('"Bullet, boxes, wrong"', text.splitlines()[0])

    def test_growth_by_the_number_of_vertices(self) -> None:
        self.measured["medians"] |= {
            "growth/depth/sat/16": {"ns": 4000.0, "edge_pairs": 1764.0},
            "growth/depth/sat/8": {"ns": 1000.0},
            "growth/distance/gjk_epa/16": {"ns": 500.0}}
        self.tables = bench_table.Tables(self.measured)
        self.assertEqual(self.row("growth", 0)["vertices"], "8")
        row = self.row("growth", 1)
        self.assertEqual(row["depth, SAT [ns]"], "4,000")
        self.assertEqual(row["pairs of edges"], "1,764")
        self.assertEqual(row["distance, GJK [ns]"], "500")
        self.assertEqual(row["depth, GJK and EPA [ns]"], "–")

    def test_wrong_answers_to_exact_pairs_and_to_reported_ones(self) -> None:
        self.measured["medians"] |= {
            "pairs/geometry_public/sat": {"asked": 308, "off_6": 0, "no_end": 2},
            "pairs/robustness_public/sat": {"asked": 58, "off_6": 1},
            "pairs/geometry_public/FCL": {"asked": 322}}
        self.tables = bench_table.Tables(self.measured)
        row = self.row("pairs", 0)
        self.assertEqual(row["method"], "`sat`")
        self.assertEqual(row["asked"], "308 / 58")
        self.assertEqual(row["off by 10⁻⁶"], "0 / 1")
        self.assertEqual(row["no end"], "2 / –")
        self.assertEqual(row["wrong side"], "–")
        self.assertEqual(self.row("pairs", 1)["asked"], "322 / –")
        self.assertEqual(len(self.tables.rows("pairs")), 2)

    def add(self, more: dict) -> None:
        bench_table.add(self.measured["medians"], more)
        self.tables = bench_table.Tables(self.measured)

    def test_stacks_say_what_a_step_takes_and_what_becomes_of_them(self) -> None:
        self.add({"stacks/pyramid/Bullet/single": {"ns": 1e6},
                  "stacks/pyramid/substeps/double": {"ns": 0.5e6},
                  "stacks/pyramid/Bullet/double": {"ns": 2e6, "stands": 0}})
        self.add({"stacks/pyramid/substeps/double": {
            "worst_depth": 0.00123456, "drift": 0.25, "energy_change": -0.01,
            "stands": 1}})
        ours, bullet = self.row("stacks", 0), self.row("stacks", 1)
        self.assertEqual(len(self.tables.rows("stacks")), 2)
        self.assertEqual((ours["scene"], ours["moved by"]), ("`pyramid`", "`substeps`"))
        self.assertEqual(ours["ms a step"], "– / 0.5")
        self.assertEqual(ours["time / Bullet's"], "– / 0.25")
        box3d = 0.5 / (0.388 / 0.809)
        self.assertEqual(ours["time / Box3D's"], f"– / {box3d:.2f}")
        self.assertEqual(ours["worst penetration [mm]"], "– / 1.23")
        self.assertEqual(ours["drift [mm]"], "– / 250")
        self.assertEqual(ours["energy [%]"], "– / −1")
        self.assertEqual((ours["stands at 60 s"], bullet["stands at 60 s"]),
                         ("– / yes", "– / no"))
        self.assertEqual(bullet["time / Bullet's"], "1.00 / 1.00")

    def test_accuracy_in_percent(self) -> None:
        self.add({"accuracy/Bullet_no_erp/double": {"ball_energy": -0.135,
                                                    "stop_error": None}})
        row = self.row("accuracy", 0)
        self.assertEqual(row["moved by"], "Bullet, ERP off")
        self.assertEqual(row["bouncing ball, energy [%]"], "– / −14")
        self.assertEqual(row["sliding block, stop [%]"], "–")

    def test_simbenchmark_by_what_is_varied_failures_and_omissions_named(self) -> None:
        self.add({"simbench/666/ODE/double/0.01": {"error": 2e-4, "seconds": 1.5},
                  "simbench/666/Bullet/double/0.01": {"error": None, "seconds": 0.5},
                  "simbench/666/ODE/double/0.003": {"error": 1e-4, "seconds": 4}})
        rows = [self.row("simbench", i) for i in range(3)]
        self.assertEqual([row["is"] for row in rows],
                         ["0.0001, left out", "0.003", "0.01"])
        self.assertEqual([row["ODE"] for row in rows],
                         ["–", "0.0001 (4)", "0.0002 (1.5)"])
        self.assertEqual([row["Bullet"] for row in rows], ["–", "–", "fails (0.5)"])

    def test_what_is_not_there_is_a_dash(self) -> None:
        self.assertEqual(self.row("kepler", 0)["GSL"], "–")
        self.assertEqual(self.row("particles", 0)["in cache, swarm [10⁶/s]"], "–")
        self.assertEqual(len(self.tables.rows("kepler")), 1)

    def test_one_table_has_all_columns(self) -> None:
        text = bench_table.markdown(self.tables.rows("all"))
        head, rule, *rows = text.splitlines()
        self.assertEqual(len(rows), 2)
        self.assertEqual({line.count("|") for line in (head, rule, *rows)},
                         {len(self.row("all", 0)) + 1})
        head, _, rk4 = bench_table.comma_separated(self.tables.rows("all")).splitlines()
        self.assertIn('"time / by hand, single","time / by hand, double"', head)
        self.assertIn(",,1.25,", rk4)
        self.assertIn("triad – / 40.0 (– / 30.0 as STREAM", self.tables.bandwidth())


if __name__ == "__main__":
    unittest.main()
