# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What callables raise while another thread collects without a pause: it comes out as itself, and nothing of it stays."""

import contextlib
import gc
import sys
import threading
import traceback
import unittest
import weakref

import numpy as np

import jalon
from lifetimes_test import collect

CALLBACKS = 500


class Mine(Exception):
    pass


class MineToo(BaseException):
    """As KeyboardInterrupt and SystemExit are."""


class Storm:
    """Collections by another thread; what lived before is left out of them, or each would take as long as a call."""

    def __init__(self):
        self.collections, self._stop = 0, threading.Event()
        self._thread = threading.Thread(target=self._run)

    def _run(self):
        while not self._stop.is_set():
            gc.collect()
            self.collections += 1

    def wait(self):
        """Until one more is done."""
        begin = self.collections
        while self.collections == begin:
            self._stop.wait(0.0005)

    def __enter__(self):
        gc.collect()
        gc.freeze()
        self._interval = sys.getswitchinterval()
        sys.setswitchinterval(2e-4)  # the calls' thread gets its turns
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._stop.set()
        self._thread.join()
        sys.setswitchinterval(self._interval)
        gc.unfreeze()


class Holder:
    """A callable that keeps the task that keeps it."""

    def __init__(self, storm, error):
        self.storm, self.error, self.task = storm, error, None

    def progress(self, fraction, stage):
        self.storm.wait()
        raise self.error

    def log(self, level, text):
        self.progress(0, text)

    def after_another(self, fraction, stage):
        """A call of its own, whose callable raises too."""
        inner = Mine("of the call within")
        try:
            jalon.Cloud(np.eye(3)).compute_normals(k=3, progress=Holder(self.storm, inner).progress)
        except Mine as caught:
            assert caught is inner
        raise self.error


class Callbacks(unittest.TestCase):
    @staticmethod
    def call(kind, cloud, holder):
        if kind == 0:
            cloud.compute_normals(k=8, progress=holder.progress)
        elif kind == 1:
            holder.task = jalon.Task(progress=holder.progress)
            cloud.compute_normals(k=8, task=holder.task)
        elif kind == 2:
            holder.task = jalon.Task(log=holder.log)
            jalon.Segmenter(min_points=10).run(cloud, task=holder.task)
        elif kind == 3:
            cloud.subsample(method="voxel", cell_m=0.2, progress=holder.after_another)
        else:
            cloud.knn_all(4, progress=lambda fraction, stage: holder.progress(fraction, stage))

    def python__what_callables_raise_in_a_storm_of_collections_comes_out_as_itself(self):
        gc.collect()
        before, kept, raised = jalon._live_handle_count(), [], 0
        with Storm() as storm:
            cloud = jalon.Cloud(np.random.default_rng(5).random((200, 3)) * [1, 1, 0.001])
            for i in range(CALLBACKS):
                error = (Mine, MineToo)[i // 5 % 2]("callback %d" % i)
                holder = Holder(storm, error)
                try:
                    self.call(i % 5, cloud, holder)
                    self.fail("call %d went on" % i)
                except (Mine, MineToo) as caught:
                    self.assertIs(caught, error)
                    self.assertEqual(caught.args, ("callback %d" % i,))
                    self.assertIn(traceback.extract_tb(caught.__traceback__)[-1].name, ("progress", "after_another"))
                    raised += 1
                kept += [weakref.ref(holder), weakref.ref(error)]
                del holder, error
            collections = storm.collections
            cloud.compute_normals(k=8)
            cloud.close()
        collect(before)
        self.assertEqual([k for k in kept if k() is not None], [])
        self.assertEqual(jalon._live_handle_count(), before)
        print("FIGURE callbacks of Python: %d of %d came out as raised, in %d collections" % (raised, CALLBACKS, collections))

    def python__a_callable_is_not_called_after_another_has_raised(self):
        """The log raised, and the call cannot end at once: a call that progress would make then must not get its exception."""
        error, calls = Mine("of the log"), []

        def log(level, text):
            raise error

        def progress(fraction, stage):
            calls.append(fraction)
            with contextlib.suppress(Mine):
                jalon.Cloud(np.eye(3)).compute_normals(k=3)
        with self.assertRaises(Mine) as caught:
            jalon.Segmenter(min_points=10).run(jalon.Cloud(np.random.default_rng(5).random((200, 3)) * [1, 1, 0.001]),
                                               task=jalon.Task(log=log, progress=progress))
        self.assertIs(caught.exception, error)
        self.assertEqual(calls, [])
