# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""A host that forks, spawns and interrupts. JALON_FULL=1: a hundred of each."""
import multiprocessing
import os
import signal
import threading
import time
import unittest

import jalon
from scenes import SANITIZED, large_cloud

FULL = "JALON_FULL" in os.environ
MINUTE = 60


def bytes_of_segments(seed):
    """Of a cloud of its own: other tests add fields to the common one."""
    cloud = jalon.Scanner("sample", spacing_m=0.1, seed=seed).run(jalon.scene_create(name="box"))
    return jalon.Segmenter(min_points=20, seed=seed).run(cloud).to_bytes()


def long_calls():
    """Ten kinds of calls of a second or more, each on what no other call has made ready."""
    def with_normals():
        cloud = large_cloud(100000)
        cloud.compute_normals(k=8)
        return cloud
    return [
        ("normals", lambda: large_cloud().compute_normals(k=60)),
        ("features", lambda: large_cloud().compute_features()),
        ("components", lambda: [large_cloud().compute_components() for _ in range(50)]),
        ("outliers", lambda: [large_cloud().remove_outliers() for _ in range(50)]),
        ("subsample", lambda: [large_cloud().subsample(method="minimum_distance") for _ in range(50)]),
        ("segmentation", lambda: [jalon.Segmenter().run(large_cloud()) for _ in range(50)]),
        ("region growing", lambda: [jalon.Segmenter("region_growing").run(with_normals()) for _ in range(50)]),
        ("distance", lambda: [jalon.Comparer().run(large_cloud(), large_cloud()) for _ in range(50)]),
        ("M3C2", lambda: [jalon.Comparer("m3c2").run(large_cloud(), large_cloud()) for _ in range(50)]),
        ("registration", lambda: [jalon.Registrar("icp").run(large_cloud(), large_cloud()) for _ in range(50)]),
    ]


class Host(unittest.TestCase):
    def other_processes(self, method, processes):
        here = bytes_of_segments(7)  # the parent's threads have worked
        for _ in range(processes):
            with multiprocessing.get_context(method).Pool(1) as pool:
                there = pool.apply_async(bytes_of_segments, (7,)).get(timeout=MINUTE)
            self.assertEqual(there, here)

    @unittest.skipIf(SANITIZED, "a sanitizer's children are slow to start")
    def python__forked_processes_work_as_their_parent(self):
        self.other_processes("fork", 100 if FULL else 5)

    @unittest.skipIf(SANITIZED, "a sanitizer's children are slow to start")
    def python__spawned_processes_work_as_their_parent(self):
        self.other_processes("spawn", 100 if FULL else 1)

    def python__ctrl_c_stops_ten_kinds_of_calls(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        handler = signal.getsignal(signal.SIGINT)
        large_cloud(), large_cloud(100000)  # made once and kept
        took, handles = [], jalon._live_handle_count()
        for name, call in long_calls():
            for turn in range(100 if FULL else 1):
                sent = []

                def interrupt():
                    time.sleep(0.05 + 0.002 * turn)
                    sent.append(time.monotonic())
                    os.kill(os.getpid(), signal.SIGINT)
                thread = threading.Thread(target=interrupt)
                with self.assertRaises(KeyboardInterrupt, msg=name):
                    thread.start()
                    call()
                took.append(1000 * (time.monotonic() - sent[0]))
                thread.join()
                self.assertEqual(jalon._live_handle_count(), handles, name)
                self.assertIs(signal.getsignal(signal.SIGINT), handler)
        took.sort()
        print("FIGURE Ctrl-C in ten kinds of calls, %d times: median %.0f ms, worst %.0f" % (len(took), took[len(took) // 2], took[-1]))
