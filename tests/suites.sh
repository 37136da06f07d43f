# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
# The suites of the release build that are scripts; sourced by run.sh ($root, $release, suite).
suite style python3 tests/style/check.py "$release"
suite abi bash tests/abi/check.sh "$release"
suite install bash tests/install/check.sh "$release"
suite libccd bash tests/install/single_ccd.sh
suite comma_locale bash tests/capi/comma_locale.sh "$release"
suite bits bash tests/scenarios/bits.sh "$release"
suite cli bash tests/scenarios/cli.sh "$release/src/jalon"
suite malformed bash tests/fuzz/malformed.sh "$release"
suite laspy bash tests/fuzz/laspy.sh "$release"
suite laspy_offline bash tests/offline.sh tests/fuzz/laspy.sh laspy
suite validators bash tests/formats/validators.sh "$release"
suite validators_offline bash tests/offline.sh tests/formats/validators.sh 'ezdxf.*'
suite accuracy "$release/tests/accuracy/accuracy"
suite examples bash tests/scenarios/examples.sh "$release"
suite bindings python3 tests/bindings/reachable.py "$release"
suite bindings_python bash tests/bindings/python.sh "$release"
suite bindings_offline bash tests/offline.sh tests/bindings/python.sh 'numpy and scikit-build-core'
suite bindings_csharp bash tests/bindings/csharp.sh "$release"
suite bindings_java bash tests/bindings/java.sh "$release"
