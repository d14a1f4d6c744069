# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of docs/safety.md#what-stops-a-motor, one row a family and a fault, as it is measured."""
import statistics


class Rows:
    def __init__(self):
        self.rows = []

    def add(self, family, fault, stopped_by, seconds, limit):
        """`seconds` of each round, from the fault to the output off (or, for a cable, from its return to the stop)."""
        figures = [1000 * value for value in seconds]
        self.rows.append((family, fault, stopped_by,
                          f"{statistics.median(figures):.0f} ({min(figures):.0f} to {max(figures):.0f})" if figures else "–",
                          f"{1000 * limit:.0f}" if limit else "–", len(figures)))

    def print(self):
        for family, fault, stopped_by, figures, limit, rounds in self.rows:
            print(f"| {family} | {fault} | {stopped_by} | {figures} | {limit} | {rounds} |", flush=True)


ROWS = Rows()
