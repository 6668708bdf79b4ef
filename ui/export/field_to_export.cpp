#include "ui/export/field_to_export.h"

#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace furrow {

namespace {

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(FieldsToExport)
};

/// It is a plan of just these inputs.
bool isPlanOf(const Plan& plan, const ProjectField& field, const FieldPlan& wanted) {
    return plan.field().source() == *field.source && plan.request.machine == wanted.machine &&
           plan.request.settings == wanted.settings && !plan.request.draft;
}

}  // namespace

std::vector<FieldToExport> fieldsToExport(const Project& project, const QStringList& ids,
                                          const std::shared_ptr<const Plan>& plan, const MadePlans& made) {
    std::vector<FieldToExport> fields;
    for (std::size_t i = 0; i < project.fields.size(); ++i) {
        const ProjectField& field = *project.fields[i];
        if (!ids.contains(fromStd(field.id))) {
            continue;
        }
        const FieldPlan& wanted = project.planOf(i);
        const bool isThere = i == project.currentField && plan != nullptr && isPlanOf(*plan, field, wanted);
        fields.push_back(
            {.field = project.fields[i],
             .wanted = wanted,
             .made = isThere ? MadePlan{.plan = plan, .advised = true} : made.find(field, wanted)});
    }
    return fields;
}

QString namesOf(const std::vector<FieldToExport>& fields) {
    constexpr std::size_t kMost = 4;
    QStringList names;
    for (std::size_t i = 0; i < std::min(kMost, fields.size()); ++i) {
        names << fromStd(fields[i].name());
    }
    const QString listed = names.join(QStringLiteral(", "));
    return fields.size() <= kMost
               ? listed
               : ExportText::tr("%1 and %n more", nullptr, static_cast<int>(fields.size() - kMost))
                     .arg(listed);
}

QStringList FieldsExported::failureTexts() const {
    QStringList texts;
    for (const Failure& failure : failures) {
        QStringList parts{sentence(failure.error.what), sentence(failure.error.remedy)};
        parts.removeAll(QString{});
        texts << ExportText::tr("%1: %2").arg(fromStd(failure.field),
                                              parts.join(QStringLiteral(". ")) + u'.');
    }
    return texts;
}

QStringList FieldsExported::problemTexts() const {
    QStringList texts;
    for (const std::string& field : withProblems) {
        texts << ExportText::tr(
                     "%1: the plan has problems and cannot be driven as drawn. The files say so too.")
                     .arg(fromStd(field));
    }
    return texts;
}

Result<FieldsExported> exportEach(
    const std::vector<FieldToExport>& fields,
    const std::function<Result<void>(const Plan& plan, const JobContext& job)>& handOn,
    const JobContext& job) {
    FieldsExported exported;
    const auto count = static_cast<double>(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const FieldToExport& field = fields[i];
        const double begin = static_cast<double>(i) / count;
        const double end = static_cast<double>(i + 1) / count;
        const double planned = begin + 0.8 * (end - begin);
        const auto plan = advisedPlan(field.made, *field.field->source, field.wanted.machine,
                                      field.wanted.settings, job.part(begin, planned));
        if (plan && *plan != field.made.plan) {
            exported.made.push_back({.of = field, .plan = *plan});
        }
        const Result<void> done =
            plan ? handOn(**plan, job.part(planned, end)) : std::unexpected(plan.error());
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        job.report(end);
        if (!done) {
            exported.failures.push_back({field.name(), done.error()});
            if (done.error().code == ErrorCode::WriteFailed) {
                break;
            }
            continue;
        }
        exported.written.push_back(field);
        if (!(*plan)->drivable()) {
            exported.withProblems.push_back(field.name());
        }
    }
    return exported;
}

}  // namespace furrow
