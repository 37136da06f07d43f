// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/facade_exchange.h"

#include <algorithm>
#include <limits>

namespace jalon {

namespace {

// Explanations are told apart where one is a thousand times as likely: a street has hundreds of parallel pairs, a wrong
// facade is metres off where a right one is centimetres, and a doubtful one costs itself alone. With 20 times as likely
// one facade of 50 drives stood on its neighbour's wall; from 5 to 10 the same pairs are doubtful, but for one in 500.
constexpr double kClearGain = 7;
// Facades that take the wall of the one before, after the first that leaves its own: neighbours of neighbours.
constexpr size_t kLongest = 3;

// Facades that go to the walls that claims say; the first leaves its own and may be on none.
struct ExchangeChain {
  double gain = -std::numeric_limits<double>::infinity();
  std::vector<const FacadeClaim*> claims;

  bool is_clear() const {
    return gain >= kClearGain &&
           std::ranges::all_of(claims, [](const FacadeClaim* c) { return c->is_within; });
  }
};

class Exchanges {
 public:
  Exchanges(std::span<const FacadeClaim> claims, uint32_t facades)
      : own_(facades, nullptr), of_wall_(facades) {
    for (const FacadeClaim& c : claims) {
      if (c.facade == c.wall) own_[c.facade] = &c;
      else of_wall_[c.wall].push_back(&c);
    }
  }

  /// The best way in which a facade leaves its wall to another; no claims where none asks for it.
  ExchangeChain best_without(uint32_t facade) {
    best_ = {}, now_ = {{}, {}};
    first_ = facade;
    now_.gain = -worth_on_own(facade);
    fill(facade);
    return best_;
  }
  bool is_on_wall(uint32_t facade) const { return own_[facade] != nullptr; }
  /// On no wall it would explain more: nothing.
  bool is_refuted(uint32_t facade) const { return own_[facade]->worth < 0; }

 private:
  double worth_on_own(uint32_t facade) const { return std::max(0.0, own_[facade]->worth); }
  // The wall was left: by whom it is taken.
  void fill(uint32_t wall) {
    for (const FacadeClaim* c : of_wall_[wall]) {
      const bool is_in_chain =
          std::any_of(now_.claims.begin(), now_.claims.end(),
                      [&](const auto* had) { return had->facade == c->facade; });
      if (is_in_chain) continue;
      const FacadeClaim* own = own_[c->facade];
      const bool is_end = c->facade == first_ || own == nullptr || c->stands_there;
      const double before = now_.gain;
      now_.claims.push_back(c);
      now_.gain += c->worth;
      if (c->facade != first_ && own != nullptr) now_.gain -= worth_on_own(c->facade);
      if (now_.gain > best_.gain) best_ = now_;
      if (!is_end && now_.claims.size() < kLongest) fill(c->facade);
      now_.claims.pop_back();
      now_.gain = before;
    }
  }

  std::vector<const FacadeClaim*> own_;  ///< of each facade; null: it is on no wall
  std::vector<std::vector<const FacadeClaim*>> of_wall_;  ///< by others than the one on it
  uint32_t first_ = 0;
  ExchangeChain now_, best_;
};

}  // namespace

FacadeExchange exchange_facades(std::span<const FacadeClaim> claims, uint32_t facades) {
  Exchanges exchanges(claims, facades);
  std::vector<std::pair<uint32_t, ExchangeChain>> clear;
  FacadeExchange made;
  for (uint32_t f = 0; f < facades; ++f) {
    if (!exchanges.is_on_wall(f)) continue;
    if (exchanges.is_refuted(f)) made.doubtful.push_back(f);
    ExchangeChain chain = exchanges.best_without(f);
    if (chain.is_clear()) clear.push_back({f, std::move(chain)});
    else if (chain.gain > -kClearGain) {
      made.doubtful.push_back(f);
      for (const FacadeClaim* c : chain.claims) made.doubtful.push_back(c->facade);
    }
  }
  // The one that explains most more first; a facade takes part in one.
  std::stable_sort(clear.begin(), clear.end(),
                   [](const auto& a, const auto& b) { return a.second.gain > b.second.gain; });
  std::vector<bool> takes_part(facades, false);
  for (const auto& [first, chain] : clear) {
    bool is_free = !takes_part[first];
    for (const FacadeClaim* c : chain.claims) is_free = is_free && !takes_part[c->facade];
    if (!is_free) continue;
    if (chain.claims.back()->facade != first) made.moves.push_back({first, 0});
    for (const FacadeClaim* c : chain.claims) made.moves.push_back({c->facade, c->offset_m});
    for (const auto& move : made.moves) takes_part[move.facade] = true;
  }
  std::erase_if(made.doubtful, [&](uint32_t f) { return takes_part[f]; });
  std::sort(made.doubtful.begin(), made.doubtful.end());
  made.doubtful.erase(std::unique(made.doubtful.begin(), made.doubtful.end()), made.doubtful.end());
  return made;
}

}  // namespace jalon
