// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace jalon {

/// A facade that may be a wall which was seen: the one that it stands on, or that of another facade.
struct FacadeClaim {
  uint32_t facade = 0;
  uint32_t wall = 0;          ///< the facade that stands on it now
  double offset_m = 0;        ///< where the facade would have to stand
  bool stands_there = false;  ///< the facade has come to that wall already
  /// Of the points that this explains, less what it costs: a logarithm of probabilities.
  double worth = 0;
  bool is_within = true;  ///< what the sigmas allow: else it makes others doubtful and is not done
};

/// Which facades go elsewhere, and of which it cannot be told which wall they are.
struct FacadeExchange {
  struct Move {
    uint32_t facade = 0;
    double offset_m = 0;  ///< 0: it is on no wall that was seen, and stays where it is given
  };
  std::vector<Move> moves;
  std::vector<uint32_t> doubtful;  ///< ascending
};

/// Explanations of the walls by the facades compared as a whole (joint compatibility: Neira & Tardos 2001): a wall is
/// one facade, a facade is one wall or none that was seen. Each facade in turn leaves its wall to a rival, whose own
/// wall a further one may take, and so on; of two that share one wall either may have all of it. What explains more by
/// a clear margin is done, and where the margin is not clear all that take part are doubtful, as is a facade whose wall
/// speaks against it. claims: those of facades on their own walls included. O(claims).
FacadeExchange exchange_facades(std::span<const FacadeClaim> claims, uint32_t facades);

}  // namespace jalon
