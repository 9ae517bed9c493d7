// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table T3.5-1 of the thesis on our data.
#include "speedup_table.h"

#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include "measuring.h"

#include <cstdio>
#include <vector>

namespace bench {
namespace {

double
medianOf(const std::vector<pcl::SpeedupReport>& reports,
         double pcl::SpeedupReport::*figure)
{
  std::vector<double> values;
  for (const pcl::SpeedupReport& report : reports)
    values.push_back(report.*figure);
  return median(values);
}

/** A row as it stands in the thesis, which gives no costs. */
void
printThesisRow(const char* name, int points, double k, double alone, double chain)
{
  std::printf("  %-32s %9d %6.2f %8.1f %8.1f %6.2f\n",
              name,
              points,
              k,
              alone,
              chain,
              alone / chain);
}

} // namespace

pcl::SpeedupReport
measureSpeedup(const Cloud::Ptr& cloud, std::size_t repeats)
{
  using Report = pcl::SpeedupReport;
  std::vector<Report> reports;
  for (std::size_t r = 0; r < repeats; ++r) {
    pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
    chain.setInputCloud(cloud);
    chain.setNumberOfThreads(1);
    reports.push_back(chain.measureSpeedup());
  }
  Report middle = reports.front();
  for (const auto figure : {&Report::base_seconds,
                            &Report::chain_seconds,
                            &Report::base_cost,
                            &Report::start_cost,
                            &Report::filter_cost})
    middle.*figure = medianOf(reports, figure);
  middle.speedup =
      middle.chain_seconds > 0 ? middle.base_seconds / middle.chain_seconds : 0;
  middle.is_advantageous = middle.connected_share * middle.base_cost >
                           middle.start_cost + middle.filter_cost;
  return middle;
}

void
printSpeedupHeadings()
{
  std::printf("T3.5-1: base algorithm alone (t_A) against the chain (t_BA), seconds on "
              "one thread;\ncosts in us/point; EC3.1-1: k c_A > c_B + c_F\n");
  std::printf("  %-32s %9s %6s %8s %8s %6s %7s %7s %7s  %s\n",
              "",
              "N",
              "k",
              "t_A",
              "t_BA",
              "S",
              "c_A",
              "c_B",
              "c_F",
              "EC3.1-1");
  printThesisRow("thesis, Pentium III 500: Bunny", 35947, 0.96, 10.4, 7.9);
  printThesisRow("thesis, Pentium III 500: Bone", 68537, 0.88, 19.9, 16.1);
}

void
printSpeedup(const std::string& name, const pcl::SpeedupReport& report)
{
  std::printf("  %-32s %9zu %6.4f %8.4f %8.4f %6.2f %7.3f %7.3f %7.3f  %s\n",
              name.c_str(),
              report.points,
              report.connected_share,
              report.base_seconds,
              report.chain_seconds,
              report.speedup,
              1e6 * report.base_cost,
              1e6 * report.start_cost,
              1e6 * report.filter_cost,
              report.is_advantageous ? "holds" : "does not hold");
  std::fflush(stdout);
}

} // namespace bench
