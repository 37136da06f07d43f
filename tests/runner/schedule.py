# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What is started next: builds one after another, suites beside them as soon as theirs stands, the longest first."""


class Schedule:
    """Pure bookkeeping: what runs is told by starts and ends, nothing is run here."""

    def __init__(self, builds, suites, at_once):
        self.builds, self.at_once = list(builds), at_once
        self.suites = [s for s in suites if not s.is_alone]
        self.alone = [s for s in suites if s.is_alone]
        self.built, self.building, self.running = set(), None, []

    def next_build(self):
        """The build to start now, or None; from then on it is under way."""
        if self.building is not None or not self.builds:
            return None
        self.building = self.builds.pop(0)
        return self.building

    def build_ended(self):
        self.built.add(self.building)
        self.building = None

    def next_suite(self):
        """The suite to start now, or None. Those that want no company come last, when all else has ended."""
        if len(self.running) >= self.at_once:
            return None
        for suite in self.suites:
            if suite.build in self.built:
                self.suites.remove(suite)
                self.running.append(suite)
                return suite
        if self.alone and not (self.suites or self.running or self.builds or self.building):
            self.running.append(self.alone.pop(0))
            return self.running[-1]
        return None

    def suite_ended(self, suite):
        self.running.remove(suite)

    @property
    def is_over(self):
        return not (self.builds or self.building or self.suites or self.alone or self.running)


def longest_first(suites, names):
    """Those that are named, in the order of the names, then the others as they come: so that no long one ends alone."""
    place = {name: i for i, name in enumerate(names)}
    return sorted(suites, key=lambda s: place.get(s.name, len(names)))
