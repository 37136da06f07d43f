# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""Laser-scan surveying: clouds, planes, models, comparison, registration.

    import jalon
    cloud = jalon.Cloud.read("scan.las")
    segmentation = jalon.Segmenter("ransac").run(cloud)
    print(segmentation.segments.to_dict())

Lengths are metres, angles radians. Arrays are NumPy arrays where NumPy is installed, else memoryviews; those that come out are
read-only views that keep their owner alive. Failures are subclasses of jalon.Error. Long calls take progress=, a callable of
(fraction, stage) that may return False to cancel, and end within a quarter of a second at Ctrl-C.
"""

from . import _api, _errors, _records
from ._api import *  # noqa: F401,F403
from ._errors import *  # noqa: F401,F403
from ._lists import Gauge, Targets
from ._records import *  # noqa: F401,F403
from ._native import live_handle_count as _live_handle_count  # noqa: F401
from ._native import version as _version

__version__ = _version()
__all__ = ["Gauge", "Targets"]
__all__ += _api.__all__
__all__ += _errors.__all__
__all__ += _records.__all__
