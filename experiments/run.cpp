#include "experiments/run.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "experiments/report/json.h"
#include "schemes/algebra/thread_caches.h"

namespace subdiv {
namespace {

/// The claims in the order of the table; std::logic_error unless each head is settled exactly once.
std::vector<Claim> in_table_order(const Experiment& experiment, const std::vector<Claim>& claims) {
  std::vector<Claim> ordered;
  for (const ClaimHead& head : experiment.heads()) {
    const auto is_head = [&](const Claim& claim) { return claim.head.id == head.id; };
    const auto found = std::find_if(claims.begin(), claims.end(), is_head);
    if (found == claims.end()) throw std::logic_error("claim '" + head.id + "' was not settled");
    if (std::any_of(found + 1, claims.end(), is_head)) {
      throw std::logic_error("claim '" + head.id + "' was settled twice");
    }
    ordered.push_back(*found);
  }
  for (const Claim& claim : claims) (void)head(experiment.heads(), claim.head.id);
  return ordered;
}

template <class Item>
void check_names(const std::vector<Item>& items) {
  std::set<std::string> names;
  for (const Item& item : items) {
    if (!is_file_name(item.name)) throw std::logic_error("'" + item.name + "' cannot name a file");
    if (!names.insert(item.name).second) throw std::logic_error("'" + item.name + "' names two files");
  }
}

Outcome run_one(const Experiment& experiment) {
  Outcome outcome{&experiment, {}, ""};
  try {
    outcome.results = experiment.run();
    outcome.results.claims = in_table_order(experiment, outcome.results.claims);
    check_names(outcome.results.series);
    check_names(outcome.results.figures);
  } catch (const std::exception& error) {
    outcome.results = {};
    outcome.error = *error.what() == '\0' ? "unknown error" : error.what();
  }
  return outcome;
}

}  // namespace

std::vector<Outcome> run(std::span<const Experiment* const> experiments, int jobs,
                         const std::function<void(const Experiment&)>& finished) {
  std::vector<Outcome> outcomes(experiments.size());
  std::atomic<std::size_t> next = 0;
  std::mutex reporting;
  const auto work = [&] {
    for (std::size_t i = next++; i < experiments.size(); i = next++) {
      outcomes[i] = run_one(*experiments[i]);
      const std::scoped_lock lock(reporting);
      if (finished) finished(*experiments[i]);
    }
  };
  const std::size_t threads = std::min(static_cast<std::size_t>(std::max(jobs, 1)), experiments.size());
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < threads; ++i) {
      others.emplace_back([&] {
        work();
        release_thread_caches();
      });
    }
    work();
  }
  return outcomes;
}

}  // namespace subdiv
