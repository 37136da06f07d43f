# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
import os
import signal
import threading
import time
import traceback
import unittest

import jalon
from scenes import box_cloud, large_cloud


class Mine(Exception):
    pass


class Calls(unittest.TestCase):
    def python__progress_grows_to_one(self):
        seen = []
        large_cloud().compute_normals(k=8, progress=lambda fraction, stage: seen.append((fraction, stage)))
        fractions = [fraction for fraction, _ in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertTrue(all(isinstance(stage, str) for _, stage in seen))

    def python__false_cancels_and_other_answers_do_not(self):
        self.assertRaises(jalon.CancelledError, large_cloud().compute_normals, k=30, progress=lambda *_: False)
        large_cloud(200000).compute_normals(k=8, progress=lambda *_: 0)

    def python__an_exception_of_the_callable_surfaces_as_itself(self):
        error = Mine("from the progress callable")

        def progress(fraction, stage):
            raise error
        try:
            large_cloud().compute_normals(k=30, progress=progress)
            self.fail("it went on")
        except Mine as caught:
            self.assertIs(caught, error)
            self.assertEqual(traceback.extract_tb(caught.__traceback__)[-1].name, "progress")
        with self.assertRaises(Mine):
            large_cloud().compute_normals(k=30, task=jalon.Task(progress=progress))
        # The thread is as good as before.
        self.assertEqual(box_cloud().compute_normals(k=8), None)

    def python__an_exception_at_the_very_end_surfaces_too(self):
        def progress(fraction, stage):
            if fraction == 1.0:
                raise Mine()
        cloud = large_cloud()
        before = jalon._live_handle_count()
        with self.assertRaises(Mine):
            cloud.subsample(method="voxel", cell_m=0.2, progress=progress)
        self.assertEqual(jalon._live_handle_count(), before)

    def python__ctrl_c_stops_a_long_call(self):
        sent = []

        def interrupt():
            time.sleep(0.2)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)
        # A shell gives its background jobs no Ctrl-C; the test wants it there too.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        for name, call in (("normals", lambda: large_cloud().compute_normals(k=60)),
                           ("a segmentation", lambda: jalon.Segmenter().run(large_cloud(), task=jalon.Task(threads=1)))):
            took = []
            for _ in range(5):
                thread = threading.Thread(target=interrupt)
                thread.start()
                with self.assertRaises(KeyboardInterrupt):
                    call()
                took.append(time.monotonic() - sent[-1])
                thread.join()
            print("FIGURE Ctrl-C ends %s after %.0f ms, %.0f at worst" % (name, 1000 * min(took), 1000 * max(took)))

    def python__another_thread_cancels_through_the_task(self):
        task = jalon.Task()
        timer = threading.Timer(0.2, task.cancel)
        timer.start()
        self.assertRaises(jalon.CancelledError, large_cloud().compute_normals, k=60, task=task)
        timer.join()
        self.assertTrue(task.is_cancelled)
        task.reset()
        box_cloud().compute_normals(k=8, task=task)

    def python__a_memory_limit_ends_a_call_and_tells_what_it_had(self):
        task = jalon.Task(threads=1, memory_limit=100_000)
        with self.assertRaisesRegex(jalon.OutOfMemoryError, "memory limit is 0.1 MiB"):
            box_cloud().compute_normals(k=8, task=task)
        task.set_memory_limit(2 ** 64 - 1)
        box_cloud().compute_normals(k=8, task=task)
        self.assertGreater(task.memory_peak, 100_000)
        self.assertRaises(ValueError, jalon.Task, memory_limit=-1)
        self.assertRaises(TypeError, jalon.Task, memory_limit="1 GB")

    def python__other_threads_run_during_a_call(self):
        ticks, stop = [0], threading.Event()

        def tick():
            while not stop.is_set():
                ticks[0] += 1
                time.sleep(0.001)
        thread = threading.Thread(target=tick)
        thread.start()
        large_cloud().compute_normals(k=16, task=jalon.Task(threads=1))
        counted = ticks[0]
        stop.set()
        thread.join()
        self.assertGreater(counted, 50)

    def python__one_task_one_call(self):
        task, errors = jalon.Task(), []

        def second():
            time.sleep(0.1)
            try:
                box_cloud().compute_normals(k=8, task=task)
            except jalon.BusyError as error:
                errors.append(error)
        thread = threading.Thread(target=second)
        thread.start()
        large_cloud().compute_normals(k=30, task=task)
        thread.join()
        self.assertEqual(len(errors), 1)

    def python__arguments_of_calls_are_checked(self):
        self.assertRaises(TypeError, box_cloud().compute_normals, progress=3)
        self.assertRaises(TypeError, box_cloud().compute_normals, progress=print, task=jalon.Task())
        self.assertRaises(jalon.InvalidArgumentError, jalon.Task, threads=1000)

    def python__the_log_comes_as_texts(self):
        lines = []
        task = jalon.Task(log=lambda level, text: lines.append((level, text)))
        jalon.Segmenter().run(box_cloud(), task=task)
        self.assertTrue(all(isinstance(text, str) and level in (1, 2, 3) for level, text in lines))
