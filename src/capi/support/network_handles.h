// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "capi/support/handles.h"
#include "registration/network/network_adjustment.h"

struct jalon_network : jalon::capi::Counted {
  jalon::NetworkAdjustment network;
  std::string codes, parameters;
};
