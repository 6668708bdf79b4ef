#include "planner/project/work_order.h"

#include "planner/core/json_text.h"
#include "planner/project/json_members.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

struct TextMember {
    const char* key;
    std::string WorkOrder::* text;
};

constexpr std::array kTexts{
    TextMember{"number", &WorkOrder::number},          TextMember{"customer", &WorkOrder::customer},
    TextMember{"address", &WorkOrder::address},        TextMember{"operator", &WorkOrder::operatorName},
    TextMember{"time_window", &WorkOrder::timeWindow}, TextMember{"product", &WorkOrder::product},
    TextMember{"rate_unit", &WorkOrder::rateUnit},     TextMember{"remark", &WorkOrder::remark}};

constexpr const char* kRate = "rate_per_ha";
constexpr const char* kStatus = "status";
constexpr const char* kActualArea = "actual_area_m2";
constexpr const char* kActualTime = "actual_time_s";

constexpr std::array kStatusIds{std::pair{WorkOrderStatus::Draft, std::string_view{"draft"}},
                                std::pair{WorkOrderStatus::Issued, std::string_view{"issued"}},
                                std::pair{WorkOrderStatus::InProgress, std::string_view{"in_progress"}},
                                std::pair{WorkOrderStatus::Done, std::string_view{"done"}}};

Error refused(std::string_view where, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = Message{where},
            .remedy = std::move(remedy)};
}

Result<std::optional<double>> amountIn(const OrderedJson& json, const char* key, std::string_view where) {
    if (!json.contains(key)) {
        return std::optional<double>{};
    }
    const OrderedJson& value = json[key];
    if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() < 0.0) {
        return std::unexpected(refused(where, message("{} of a work order is no amount", key),
                                       "give a number that is not negative, or leave it out"));
    }
    return std::optional{value.get<double>()};
}

}  // namespace

std::string_view statusId(WorkOrderStatus status) {
    return kStatusIds[static_cast<std::size_t>(status)].second;
}

std::optional<WorkOrderStatus> statusFrom(std::string_view id) {
    for (const auto& [status, known] : kStatusIds) {
        if (known == id) {
            return status;
        }
    }
    return std::nullopt;
}

std::string workOrderJson(const WorkOrder& order) {
    OrderedJson json = OrderedJson::object();
    for (const TextMember& member : kTexts) {
        if (!(order.*member.text).empty()) {
            json[member.key] = order.*member.text;
        }
    }
    if (order.ratePerHectare) {
        json[kRate] = *order.ratePerHectare;
    }
    if (order.status != WorkOrderStatus::Draft) {
        json[kStatus] = statusId(order.status);
    }
    if (order.actualArea) {
        json[kActualArea] = order.actualArea->si();
    }
    if (order.actualTime) {
        json[kActualTime] = order.actualTime->si();
    }
    addMembers(json, order.others);
    return textOf(json);
}

Result<WorkOrder> parseWorkOrder(std::string_view text, std::string_view where) {
    const OrderedJson json = jsonOrDiscarded<OrderedJson>(text);
    if (!json.is_object()) {
        return std::unexpected(refused(where, "a work order is a JSON object, and this is none",
                                       "see the README for the members of a work order"));
    }
    WorkOrder order;
    for (const TextMember& member : kTexts) {
        if (json.contains(member.key) && !json[member.key].is_string()) {
            return std::unexpected(refused(where, message("{} of a work order is no text", member.key),
                                           "put it in quotation marks"));
        }
        order.*member.text = json.value(member.key, "");
    }
    const auto rate = amountIn(json, kRate, where);
    const auto area = amountIn(json, kActualArea, where);
    const auto time = amountIn(json, kActualTime, where);
    for (const auto* amount : {&rate, &area, &time}) {
        if (!*amount) {
            return std::unexpected(amount->error());
        }
    }
    order.ratePerHectare = *rate;
    order.actualArea = area->transform([](double si) { return Area::fromSi(si); });
    order.actualTime = time->transform([](double si) { return Duration::fromSi(si); });
    if (json.contains(kStatus)) {
        const auto status =
            json[kStatus].is_string() ? statusFrom(json[kStatus].get<std::string>()) : std::nullopt;
        if (!status) {
            return std::unexpected(refused(where, "there is no such status of a work order",
                                           "it is draft, issued, in_progress or done"));
        }
        order.status = *status;
    }
    order.others = otherMembers(json, {"number", "customer", "address", "operator", "time_window", "product",
                                       "rate_unit", "remark", kRate, kStatus, kActualArea, kActualTime});
    return order;
}

WorkOrder orderForAnotherPlan(const WorkOrder& order) {
    WorkOrder next;
    next.customer = order.customer;
    next.operatorName = order.operatorName;
    next.product = order.product;
    next.ratePerHectare = order.ratePerHectare;
    next.rateUnit = order.rateUnit;
    return next;
}

std::optional<double> totalAmount(const WorkOrder& order, Area worked) {
    return order.ratePerHectare.transform([worked](double rate) { return rate * inHectares(worked); });
}

}  // namespace furrow
