// SPDX-License-Identifier: MIT
// See collect_ranking.h.
#include "app/sweep/collect_ranking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/plots/markup.h"
#include "sim/base/shell_quoted.h"

namespace pabd {
namespace {

constexpr std::size_t kNamedEquals = 4;  // equal tasks that are named
constexpr const char* kStepTime = "step_time";
constexpr double kUnmeasured = 0.1;  // noise of a time, of it, where it was not measured

std::string number_of(const CollectedSweep& sweep, std::size_t task) {
  const SweptTask& one = sweep.tasks[task];
  return one.index < 0 ? one.hash : std::to_string(one.index);
}

struct Measured {
  std::size_t task;
  double size;
};

// Of the acceptable tasks.
std::vector<Measured> sorted(const CollectedSweep& sweep, const Criterion& criterion) {
  std::vector<Measured> out;
  for (std::size_t i = 0; i < criterion.sizes.size(); ++i) {
    if (criterion.sizes[i] && sweep.tasks[i].faults.empty()) out.push_back({i, *criterion.sizes[i]});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Measured& a, const Measured& b) { return a.size < b.size; });
  return out;
}

// ms
double noise_of(const SweptTask& task, double time) {
  return task.timing && task.timing->noise ? *task.timing->noise : kUnmeasured * time;
}

// Sizes to be compared. Times are not reproducible: those that exceed the least of them by less than the noise of both
// count as that one, then those that exceed the least of the others, and so on.
std::vector<double> compared_sizes(const CollectedSweep& sweep, const Criterion& criterion,
                                   const std::vector<std::size_t>& tasks) {
  std::vector<double> sizes;
  for (const std::size_t task : tasks) sizes.push_back(*criterion.sizes[task]);
  if (criterion.quantity.key != kStepTime) return sizes;
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  double least = 0, noise = -1;
  for (const std::size_t i : order) {
    const double own = noise_of(sweep.tasks[tasks[i]], sizes[i]);
    if (noise < 0 || sizes[i] - least > std::hypot(own, noise)) {
      least = sizes[i];
      noise = own;
    }
    sizes[i] = least;
  }
  return sizes;
}

double median(const std::vector<Measured>& sorted) {
  const std::size_t n = sorted.size();
  return n % 2 == 1 ? sorted[n / 2].size
                    : sorted[n / 2 - 1].size + 0.5 * (sorted[n / 2].size - sorted[n / 2 - 1].size);
}

// "Least penetration: …".
std::string best_sentence(const CollectedSweep& sweep, const Criterion& criterion) {
  const std::vector<Measured> all = sorted(sweep, criterion);
  const std::string& name = criterion.quantity.words;
  if (all.empty()) {
    const bool told = std::any_of(criterion.sizes.begin(), criterion.sizes.end(),
                                  [](const auto& size) { return size.has_value(); });
    return fmt::format("No {}task tells its {}.", told ? "acceptable " : "", name);
  }
  const auto words = [&](double size) { return in_words(size, criterion.quantity.unit); };
  std::vector<std::size_t> tasks;
  for (const Measured& one : all) tasks.push_back(one.task);
  const std::vector<double> compared = compared_sizes(sweep, criterion, tasks);
  const double least = all.front().size, most = all.back().size;
  const char* noise = criterion.quantity.key == kStepTime ? " within the noise" : "";
  if (all.size() == 1)
    return fmt::format("Least {}: {}, the only one that tells it, with {}.", name,
                       task_words(sweep, all[0].task), words(least));
  if (compared.front() == compared.back())
    return fmt::format("All {} tasks have the same {}{}, {}.", all.size(), name, noise,
                       least == most ? words(least) : words(least) + " to " + words(most));
  std::vector<std::string> best;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (compared[i] == least) best.push_back(number_of(sweep, all[i].task));
  }
  const std::string who = best.size() == 1
                              ? task_words(sweep, all[0].task)
                              : fmt::format("tasks {}, which are equal{},", named(best, kNamedEquals), noise);
  return fmt::format("Least {}: {} with {}; the median of {} is {}, the most is {} of task {}.", name, who,
                     words(least), all.size(), words(median(all)), words(most),
                     number_of(sweep, all.back().task));
}

// Errors, and one cost: time and iterations are not independent.
std::vector<std::size_t> counted_criteria(const std::vector<Criterion>& criteria) {
  const Criterion* cost = cost_of(criteria);
  std::vector<std::size_t> out;
  for (std::size_t c = 0; c < criteria.size(); ++c) {
    if (!criteria[c].cost || &criteria[c] == cost) out.push_back(c);
  }
  return out;
}

// Acceptable tasks that have every counted criterion.
std::vector<std::size_t> comparable(const CollectedSweep& sweep, const Ranking& ranking) {
  std::vector<std::size_t> tasks;
  if (ranking.counted.empty()) return tasks;
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
    if (!sweep.tasks[i].faults.empty()) continue;
    if (std::all_of(ranking.counted.begin(), ranking.counted.end(),
                    [&](std::size_t c) { return ranking.criteria[c].sizes[i].has_value(); }))
      tasks.push_back(i);
  }
  return tasks;
}

// 1 + how many are smaller.
std::vector<std::size_t> ranks_of(const std::vector<double>& sizes) {
  std::vector<double> order = sizes;
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> ranks;
  for (const double size : sizes)
    ranks.push_back(
        1 + static_cast<std::size_t>(std::lower_bound(order.begin(), order.end(), size) - order.begin()));
  return ranks;
}

std::string overall_sentence(const CollectedSweep& sweep, const Ranking& ranking) {
  if (ranking.criteria.empty()) return "No task tells a metric, so that there is nothing to rank.";
  if (ranking.compared == 0 && ranking.unacceptable > 0) {
    const auto first = std::find_if(sweep.tasks.begin(), sweep.tasks.end(),
                                    [](const SweptTask& task) { return !task.faults.empty(); });
    return fmt::format("None is acceptable: of {}, {}.",
                       task_words(sweep, static_cast<std::size_t>(first - sweep.tasks.begin())),
                       escape_markup(first->faults));
  }
  if (ranking.compared == 0)
    return "No task that is done tells every metric, so that none is the best of all.";
  const Ranked& first = ranking.front.front();
  if (ranking.compared == 1) {
    return fmt::format("Only {} is done and tells every metric: there is nothing to compare it with.",
                       task_words(sweep, first.task));
  }
  std::string out = fmt::format("On the whole {} is best: ", task_words(sweep, first.task));
  out += ranking.front.size() == 1
             ? fmt::format("none of the {} compared is less in anything", ranking.compared)
             : fmt::format(
                   "of the {} compared, {} are on the Pareto front (no other is at most as much in "
                   "everything and less in something), and of these it has the least sum of ranks, {}",
                   ranking.compared, ranking.front.size(), first.sum);
  for (std::size_t k = 0; k < ranking.counted.size(); ++k) {
    const Criterion& criterion = ranking.criteria[ranking.counted[k]];
    out += fmt::format("{} rank {} in {} ({})", k == 0 ? ":" : ",", first.ranks[k], criterion.quantity.words,
                       in_words(*criterion.sizes[first.task], criterion.quantity.unit));
  }
  out += ".";
  if (ranking.front.size() > 1) {
    const Ranked& second = ranking.front[1];
    out += fmt::format(" Next comes {} with a sum of {}.", task_words(sweep, second.task), second.sum);
  }
  if (ranking.unacceptable > 0)
    out += fmt::format(" {} not compared: the column \"why\" says what makes {} unacceptable.",
                       ranking.unacceptable == 1 ? "One is" : fmt::format("{} are", ranking.unacceptable),
                       ranking.unacceptable == 1 ? "it" : "them");
  return out;
}

}  // namespace

std::string task_words(const CollectedSweep& sweep, std::size_t task) {
  const std::string parameters = in_words(sweep, sweep.tasks[task], varied_parameters(sweep));
  const std::string number = "task " + number_of(sweep, task);
  return parameters.empty() ? number : number + " (" + parameters + ")";
}

std::string view_command(const CollectedSweep& sweep, const SweptTask& task) {
  if (sweep.scene.empty()) return {};
  std::string out = "pabd view " + sh_word(sweep.scene);
  for (const std::string& setting : settings_of(sweep, task)) out += " --set " + sh_word(setting);
  return out;
}

std::vector<Criterion> criteria_of(const CollectedSweep& sweep) {
  std::vector<Criterion> criteria;
  const auto add = [&](const SweptQuantity& quantity, bool cost, auto&& value) {
    Criterion criterion{quantity, cost, {}};
    for (const SweptTask& task : sweep.tasks) {
      const std::optional<double> v = task.status == SweptStatus::done ? value(task) : std::nullopt;
      criterion.sizes.push_back(v ? std::optional(std::abs(*v)) : std::nullopt);
    }
    criteria.push_back(std::move(criterion));
  };
  for (std::size_t m = 0; m < sweep.metrics.size(); ++m) {
    const std::string& key = sweep.metrics[m].key;
    add(sweep.metrics[m], key == "iterations" || key == kStepTime,
        [m](const SweptTask& t) { return t.metrics[m]; });
  }
  const bool timed = std::any_of(sweep.tasks.begin(), sweep.tasks.end(),
                                 [](const SweptTask& t) { return t.timing && t.timing->step_time; });
  if (timed) {
    add({kStepTime, "time a step", "time a step", "ms"}, true,
        [](const SweptTask& t) { return t.timing ? t.timing->step_time : std::nullopt; });
  }
  return criteria;
}

const Criterion* cost_of(std::span<const Criterion> criteria) {
  const Criterion* cost = nullptr;
  for (const Criterion& criterion : criteria) {
    if (criterion.cost && (!cost || criterion.quantity.key == kStepTime)) cost = &criterion;
  }
  return cost;
}

std::vector<std::size_t> pareto_front(std::span<const double> points, std::size_t dimensions) {
  if (dimensions == 0) return {};
  const std::size_t n = points.size() / dimensions;
  const auto point = [&](std::size_t i) { return points.subspan(i * dimensions, dimensions); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::lexicographical_compare(point(a).begin(), point(a).end(), point(b).begin(), point(b).end());
  });
  // In this order only points before it can dominate a point, and then one of the front does.
  const auto beats = [&](std::size_t a, std::size_t b) {
    bool less = false;
    for (std::size_t d = 0; d < dimensions; ++d) {
      if (point(a)[d] > point(b)[d]) return false;
      less = less || point(a)[d] < point(b)[d];
    }
    return less;
  };
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (std::none_of(front.begin(), front.end(), [&](std::size_t f) { return beats(f, i); }))
      front.push_back(i);
  }
  std::sort(front.begin(), front.end());
  return front;
}

Ranking rank(const CollectedSweep& sweep) {
  Ranking ranking;
  ranking.criteria = criteria_of(sweep);
  ranking.counted = counted_criteria(ranking.criteria);
  const std::vector<std::size_t> tasks = comparable(sweep, ranking);
  ranking.compared = tasks.size();
  ranking.unacceptable = static_cast<std::size_t>(std::count_if(
      sweep.tasks.begin(), sweep.tasks.end(), [](const SweptTask& task) { return !task.faults.empty(); }));
  std::vector<double> points(tasks.size() * ranking.counted.size());
  std::vector<std::vector<std::size_t>> ranks;
  for (std::size_t c = 0; c < ranking.counted.size(); ++c) {
    const auto sizes = compared_sizes(sweep, ranking.criteria[ranking.counted[c]], tasks);
    for (std::size_t i = 0; i < tasks.size(); ++i) points[i * ranking.counted.size() + c] = sizes[i];
    ranks.push_back(ranks_of(sizes));
  }
  for (const std::size_t i : pareto_front(points, ranking.counted.size())) {
    Ranked one{tasks[i], {}, 0};
    for (const auto& column : ranks) {
      one.ranks.push_back(column[i]);
      one.sum += column[i];
    }
    ranking.front.push_back(std::move(one));
  }
  std::stable_sort(ranking.front.begin(), ranking.front.end(),
                   [](const Ranked& a, const Ranked& b) { return a.sum < b.sum; });
  for (const Criterion& criterion : ranking.criteria)
    ranking.sentences.push_back(best_sentence(sweep, criterion));
  ranking.sentences.push_back(overall_sentence(sweep, ranking));
  return ranking;
}

}  // namespace pabd
