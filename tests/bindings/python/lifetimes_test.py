# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import collections
import concurrent.futures
import gc
import os
import random
import threading
import time
import unittest

import numpy as np

import jalon
from scenes import SANITIZED, box_cloud, large_cloud

CLOSES = 100 if SANITIZED else 1000 if os.environ.get("JALON_FULL") else 300
CYCLES = 100 if SANITIZED else 10000 if os.environ.get("JALON_FULL") else 500
LIMIT_BYTES = 8 << 20


def resident_bytes():
    with open("/proc/self/statm") as f:
        return int(f.read().split()[1]) * os.sysconf("SC_PAGESIZE")


def collect(handles):
    """Collects until so many handles live: a collection that another thread has begun makes one's own do nothing."""
    for _ in range(200):
        gc.collect()
        if jalon._live_handle_count() == handles:
            return
        time.sleep(0.01)


class Lifetimes(unittest.TestCase):
    def cycles(self, once, count=CYCLES):
        """Runs once(i) so often; live handles must come back, memory must not grow."""
        gc.collect()
        before = jalon._live_handle_count()
        for i in range(max(200, count // 10)):
            once(i)
        collect(before)
        begin = resident_bytes()
        for i in range(count):
            once(i)
        collect(before)
        growth = resident_bytes() - begin
        self.assertEqual(jalon._live_handle_count(), before)
        print("FIGURE %s: %d cycles, %.1f MiB growth (limit 8)" % (self.id().split(".")[-1], count, growth / 2 ** 20))
        if not SANITIZED:
            self.assertLess(growth, LIMIT_BYTES)

    def python__create_use_close_leaves_nothing(self):
        xyz = np.random.default_rng(1).random((200, 3))

        def once(_):
            with jalon.Cloud(xyz) as cloud:
                cloud.compute_normals(k=8)
                fields = cloud.fields
                self.assertEqual(fields["normal"].shape, (200, 3))
                fields.close()
                cloud.close()
        self.cycles(once)

    def python__create_use_drop_leaves_nothing(self):
        xyz = np.random.default_rng(1).random((200, 3))
        segmenter = jalon.Segmenter(distance_tolerance_m=0.05, min_points=10)

        def once(i):
            cloud = jalon.Cloud(xyz)
            cloud.set_field("value", xyz[:, 0])
            result = cloud.split("value", 0.5)
            kept = [cloud.points, result.others.points, cloud.fields["value"]]
            if i % 10 == 0:
                kept.append(segmenter.run(cloud).segments)
            random.shuffle(kept)
        self.cycles(once)

    def python__failures_leave_nothing(self):
        def once(_):
            for wrong in (lambda: jalon.Cloud.read("no such.las"), lambda: jalon.Segmenter("no"), lambda: jalon.Params("no"),
                          lambda: jalon.Cloud(np.full((4, 3), np.nan)), lambda: jalon.Segmenter(distance_tolerance_m=-1)):
                self.assertRaises(jalon.Error, wrong)
        self.cycles(once)

    def python__finalisers_in_any_order_under_a_storm(self):
        """Cycles of objects that refer to each other, collected by another thread's storm of collections."""
        stop = threading.Event()

        def storm():
            while not stop.is_set():
                gc.collect()
        thread = threading.Thread(target=storm)
        thread.start()
        xyz = np.random.default_rng(1).random((50, 3))

        class Node:
            pass

        def once(_):
            a, b = Node(), Node()
            a.other, b.other = b, a
            a.cloud = jalon.Cloud(xyz)
            b.fields, b.view = a.cloud.fields, a.cloud.points
            a.more = a.cloud.select([1, 2, 3])
        try:
            self.cycles(once)
        finally:
            stop.set()
            thread.join()

    def python__closing_twice_is_harmless_and_use_after_close_raises(self):
        cloud = jalon.Cloud([(0, 0, 0)])
        cloud.close()
        cloud.close()
        self.assertTrue(cloud.closed)
        self.assertIn("closed", repr(cloud))
        for use in (lambda: cloud.points, lambda: cloud.count, lambda: cloud.append(box_cloud()),
                    lambda: box_cloud().append(cloud), lambda: jalon.Segmenter().run(cloud)):
            self.assertRaises(jalon.ClosedError, use)
        segmenter = jalon.Segmenter()
        segmenter.close()
        self.assertRaises(jalon.ClosedError, segmenter.run, box_cloud())
        self.assertRaises(jalon.ClosedError, setattr, segmenter, "distance_tolerance_m", 1)

    def python__closing_during_a_call_raises_and_the_call_ends_well(self):
        cloud = large_cloud().select(np.arange(400000))
        task, refused = jalon.Task(), []

        def other():
            time.sleep(0.05)
            for closed in (cloud, task):
                try:
                    closed.close()
                except jalon.BusyError as error:
                    refused.append(str(error))
        thread = threading.Thread(target=other)
        thread.start()
        cloud.compute_normals(k=40, task=task)
        thread.join()
        self.assertEqual(len(refused), 2, refused)
        self.assertEqual(cloud["normal"].shape, (400000, 3))
        cloud.close()

    def python__closes_race_with_calls_of_another_thread(self):
        """Each ends well or is refused, whichever comes first."""
        xyz, told = np.random.default_rng(3).random((300, 3)), collections.Counter()
        gc.collect()
        before = jalon._live_handle_count()

        def use(cloud, began):
            began.set()
            for call in (lambda: cloud.compute_normals(k=8), lambda: cloud.knn_all(3), lambda: cloud.subsample(method="voxel", cell_m=0.1)) * 2:
                try:
                    call()
                    told["calls done"] += 1
                except jalon.ClosedError:
                    told["calls refused"] += 1
                time.sleep(2e-4)  # room for a close between two calls
        with concurrent.futures.ThreadPoolExecutor(1) as other:
            for i in range(CLOSES):
                cloud, began = jalon.Cloud(xyz), threading.Event()
                done = other.submit(use, cloud, began)
                began.wait()
                time.sleep(i % 10 * 2e-4)
                try:
                    cloud.close()
                    told["closed"] += 1
                except jalon.BusyError:
                    told["busy"] += 1
                done.result()
                cloud.close()
                del cloud
        del done
        collect(before)
        self.assertEqual(jalon._live_handle_count(), before)
        self.assertEqual(told["closed"] + told["busy"], CLOSES)
        self.assertEqual(told["calls done"] + told["calls refused"], 6 * CLOSES)
        self.assertGreater(min(told[name] for name in ("closed", "calls done", "calls refused")), 0, told)
        print("FIGURE closes that race with calls in Python: %s" % ", ".join("%d %s" % (n, what) for what, n in sorted(told.items())))

    def python__results_are_not_made_by_calling_their_class(self):
        self.assertRaises(TypeError, jalon.Segmentation)
        self.assertRaises(TypeError, jalon.Fields)
