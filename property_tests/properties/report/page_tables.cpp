#include "properties/report/page_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "case/escape.hpp"
#include "properties/report/page_legend.hpp"

namespace rayproof {

namespace {

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

std::string heads(std::initializer_list<const char*> names) {
  return fmt::format("<th>{}</th>", fmt::join(names, "</th><th>"));
}

std::string table(const std::string& head, const std::string& body) {
  return fmt::format("<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>",
                     head, body);
}

std::string details(const char* summary, const std::string& inside) {
  return fmt::format("<details><summary>{}</summary>{}</details>\n", summary, inside);
}

std::string status_cell(const Cell& one) {
  return fmt::format("<td class=\"{}\" title=\"{}: {} ({} cases)\">{}</td>", text_of(one.status).style,
                     escaped(one.property->name), escaped(text_of(one.status).words), one.tally.judged(),
                     text_of(one.status).sign);
}

/// "1.6 of 2, 1.1 of 4, 0.9 of 4": point, normal and, of a triangle, coordinates; nothing where none was
/// judged.
std::string hit_figures(const Worst& worst, const HitBounds& bounds) {
  if (worst.details == 0) return "";
  const std::string text =
      figure(worst.point, bounds.point.promised) + ", " + figure(worst.normal, bounds.normal.promised);
  const bool has_coordinates = std::isfinite(bounds.coordinates.promised);
  return has_coordinates ? text + ", " + figure(worst.coordinates, bounds.coordinates.promised) : text;
}

/// "0.93 of 8" for each measure; nothing where none was taken.
std::string measured_cells(const Row& row) {
  const Contract& contract = row.subject->contract;
  const Worst& worst = row.worst;
  if (!row.is_measured()) return "<td></td><td></td><td></td><td></td><td></td>";
  return cell(fmt::format("{} of {}", worst.wrong, worst.cases)) +
         cell(figure(worst.verdict, contract.verdict.promised)) +
         cell(figure(worst.residual, contract.residual.promised)) +
         cell(figure(worst.ulp, contract.ulp.promised)) + cell(hit_figures(worst, contract.hit));
}

/// One row for each method and precision, and what `cells` has to say of it.
template <class Cells>
std::string method_table(const std::string& head, const Summary& summary, const Cells& cells) {
  std::string body;
  for (const Row& row : summary.rows)
    body += fmt::format("<tr><td title=\"{}\">{}</td><td>{}</td>{}</tr>\n", escaped(row.subject->title),
                        escaped(row.subject->full_name()), name_of(row.precision), cells(row));
  return table(heads({"method", "precision"}) + head, body);
}

}  // namespace

std::string claims_table(const Summary& summary) {
  // A property of which no method says anything has no column.
  const auto is_claimed = [&](std::size_t p) {
    return std::ranges::any_of(summary.rows,
                               [p](const Row& row) { return row.cells[p].status != ClaimStatus::unclaimed; });
  };
  std::string head = heads({"cases"});
  for (std::size_t p = 0; p < properties().size(); ++p)
    if (is_claimed(p))
      head += fmt::format(R"(<th class="claim" title="{}"><span>{}</span></th>)",
                          escaped(properties()[p].statement), escaped(properties()[p].name));
  std::string legend;
  for (const ClaimStatus status : statuses_in_legend)
    legend += fmt::format("<span><span class=\"{}\">{}</span> {}</span> ", text_of(status).style,
                          text_of(status).sign, escaped(text_of(status).words));
  const auto cells = [&](const Row& row) {
    std::string all = cell(std::to_string(row.cases));
    for (std::size_t p = 0; p < row.cells.size(); ++p)
      if (is_claimed(p)) all += status_cell(row.cells[p]);
    return all;
  };
  return fmt::format("<p class=\"legend\">{}</p>{}\n", legend, method_table(head, summary, cells));
}

std::string errors_table(const Summary& summary) {
  const std::string head = heads({"wrong verdicts, in the domain", "widest verdict band", "worst residual",
                                  "worst ulp", "worst point, normal, coordinates"});
  return method_table(head, summary, measured_cells) + page_legend;
}

std::string family_table(const RunResult& result) {
  std::string body;
  for (const Unit& unit : result.units) {
    const Worst& worst = unit.tally.worst;
    if (worst.cases > 0)
      body += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
          "<td>{}</td></tr>\n",
          escaped(unit.subject->full_name()), name_of(unit.precision), escaped(unit.family->name),
          worst.cases, worst.wrong, figure(worst.verdict), figure(worst.residual), figure(worst.ulp));
  }
  const std::string head = heads({"method", "precision", "family", "cases in domain", "wrong verdicts",
                                  "verdict band", "residual", "ulp"});
  return details("Worst errors of each method on each family", table(head, body));
}

std::string label_table(const RunResult& result) {
  std::string body;
  for (const LabelCount& labels : result.labels)
    body += fmt::format(
        "<tr><td>{}/{}</td><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
        escaped(labels.family->topic), escaped(labels.family->name), name_of(labels.precision),
        escaped(labels.family->description), escaped(labels.shares()));
  return details("What the families produced", table(heads({"family", "precision", "aim", "labels"}), body));
}

}  // namespace rayproof
