#pragma once

#include "planner/core/result.h"
#include "planner/units/quantity.h"

#include <optional>
#include <string>
#include <string_view>

namespace furrow {

enum class WorkOrderStatus { Draft, Issued, InProgress, Done };

/// "draft", "issued", "in_progress", "done": as in project files.
std::string_view statusId(WorkOrderStatus status);
/// The status with such an id. Empty for other texts.
std::optional<WorkOrderStatus> statusFrom(std::string_view id);

/// What a plan is handed out with: for whom, where, by whom and when, with what, and what came of it. Texts
/// are as the user typed them; empty where nothing was said.
struct WorkOrder {
    std::string number;    ///< "2026-014"
    std::string customer;  ///< may have several lines, as the address
    std::string address;   ///< of the field
    std::string operatorName;
    std::string timeWindow;  ///< "3 April, 7:00 to 12:00"
    std::string product;
    std::optional<double> ratePerHectare;  ///< in `rateUnit` per hectare; not negative
    std::string rateUnit;                  ///< "kg"
    WorkOrderStatus status = WorkOrderStatus::Draft;
    std::optional<Area> actualArea;
    std::optional<Duration> actualTime;
    std::string remark;
    /// Members of a file that this version does not know, as a JSON object; empty for none.
    std::string others;

    friend bool operator==(const WorkOrder&, const WorkOrder&) = default;
};

/// As a JSON object; members of which nothing is said are left out.
std::string workOrderJson(const WorkOrder& order);

/// The same read. Members that are not known are kept in `others`.
///
/// @param where  the file, for messages
/// @return InputRefused, naming the member: no JSON object, a text that is none, a number that is negative or
///         not finite, an unknown status.
Result<WorkOrder> parseWorkOrder(std::string_view json, std::string_view where);

/// For the next plan: customer, operator, product and rate stay; what belongs to one job is gone.
WorkOrder orderForAnotherPlan(const WorkOrder& order);

/// How much of the product goes on this area. Empty without a rate.
std::optional<double> totalAmount(const WorkOrder& order, Area worked);

}  // namespace furrow
