// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/stagededits.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/leap.h"

#include <algorithm>

namespace mb {

/// Old and new text of one edit; nothing means no edit.
class StagedEdits::Step final : public QUndoCommand {
public:
    Step(StagedEdits &edits, ParameterIndex index, std::optional<QString> before, std::optional<QString> after,
        QUndoCommand *parent)
        : QUndoCommand(qt(edits.parameter(index).key), parent)
        , m_edits(edits)
        , m_index(index)
        , m_before(std::move(before))
        , m_after(std::move(after))
    {
    }
    void undo() override { m_edits.put(m_index, m_before); }
    void redo() override { m_edits.put(m_index, m_after); }

private:
    StagedEdits &m_edits;
    ParameterIndex m_index;
    std::optional<QString> m_before;
    std::optional<QString> m_after;
};

StagedEdits::StagedEdits(const Family &family, QObject *parent)
    : QObject(parent)
    , m_family(family)
    , m_entries(family.parameters.size())
{
    m_undo.setUndoLimit(500);
}

std::optional<std::int64_t> StagedEdits::known(ParameterIndex index) const
{
    const auto &entry = m_entries[index.value];
    return entry.state == ParameterState::Failed ? std::nullopt : entry.raw;
}

bool StagedEdits::isSettled(ParameterIndex index, const StagedEdit &edit) const
{
    return edit.value.raw && edit.value.raw == known(index);
}

void StagedEdits::setEntries(std::span<const ParameterStore::Entry> entries)
{
    m_entries.assign(entries.begin(), entries.end());
    std::vector<ParameterIndex> came;
    for (const auto &[index, edit] : m_edits) {
        if (isSettled(index, edit))
            came.push_back(index);
    }
    for (const ParameterIndex index : came) {
        m_edits.erase(index);
        Q_EMIT changed(index);
    }
}

void StagedEdits::type(ParameterIndex index, const QString &text)
{
    if (m_typing && *m_typing != index)
        endTyping(true);
    m_typing = index;
    const StagedEdit *before = m_edits.contains(index) ? &m_edits.at(index) : nullptr;
    m_typed = {text, parseValue(parameter(index), text), !before || before->included};
    Q_EMIT changed(index);
}

void StagedEdits::endTyping(bool keep)
{
    if (!m_typing)
        return;
    const ParameterIndex index = *m_typing;
    m_typing.reset();
    if (keep)
        push(index, asWritten(m_typed.text)); // what stands in the table is what will be written
    Q_EMIT changed(index);
}

void StagedEdits::push(ParameterIndex index, const QString &text, QUndoCommand *macro)
{
    const auto staged = m_edits.find(index);
    const auto raw = known(index);
    std::optional<QString> before;
    if (staged != m_edits.end())
        before = staged->second.text;
    else if (raw)
        before = fieldText(parameter(index), *raw);
    const bool same = before
        && (*before == text
            || (parseValue(parameter(index), text).raw
                && parseValue(parameter(index), text).raw == parseValue(parameter(index), *before).raw));
    if (same)
        return;
    auto *const step = new Step(*this, index, before, text, macro);
    if (!macro)
        m_undo.push(step);
}

void StagedEdits::stage(ParameterIndex index, const QString &text)
{
    if (m_typing == index)
        m_typing.reset();
    push(index, text);
    Q_EMIT changed(index);
}

void StagedEdits::stageAll(const std::vector<ParameterChange> &changes, const QString &title)
{
    endTyping(true);
    auto macro = std::make_unique<QUndoCommand>(title);
    for (const ParameterChange &change : changes)
        push(change.index, fieldText(parameter(change.index), change.raw), macro.get());
    if (macro->childCount() > 0) // nothing differs: there is nothing to take back
        m_undo.push(macro.release());
}

void StagedEdits::revert(ParameterIndex index)
{
    if (m_typing == index)
        m_typing.reset();
    if (const auto staged = m_edits.find(index); staged != m_edits.end())
        m_undo.push(new Step(*this, index, staged->second.text, std::nullopt, nullptr));
    Q_EMIT changed(index);
}

void StagedEdits::discard()
{
    endTyping(false);
    if (m_edits.empty())
        return;
    const auto edits = m_edits;
    m_undo.beginMacro(tr("Discard"));
    for (const auto &[index, edit] : edits)
        m_undo.push(new Step(*this, index, edit.text, std::nullopt, nullptr));
    m_undo.endMacro();
}

void StagedEdits::settle(const std::vector<ParameterChange> &sent)
{
    for (const ParameterChange &change : sent) {
        const auto staged = m_edits.find(change.index);
        if (staged == m_edits.end() || staged->second.value.raw != change.raw)
            continue;
        m_edits.erase(staged);
        Q_EMIT changed(change.index);
    }
    // A step of what is written now would stage its former value: what is left is all that there is to take back.
    const auto left = m_edits;
    std::vector<std::pair<ParameterIndex, StagedEdit>> steps(left.begin(), left.end());
    std::ranges::sort(steps, {}, [](const auto &step) { return step.second.place; });
    m_undo.clear();
    for (const auto &[index, edit] : steps) {
        const auto raw = known(index);
        const auto before = raw ? std::optional(fieldText(parameter(index), *raw)) : std::nullopt;
        m_undo.push(new Step(*this, index, before, edit.text, nullptr));
    }
    m_edits = left; // with what was chosen of each
}

void StagedEdits::put(ParameterIndex index, const std::optional<QString> &text)
{
    const auto staged = m_edits.find(index);
    const bool included = staged == m_edits.end() || staged->second.included;
    if (staged != m_edits.end())
        m_edits.erase(staged);
    if (text) {
        StagedEdit edit{
            .text = *text, .value = parseValue(parameter(index), *text), .included = included, .place = ++m_places};
        if (!isSettled(index, edit))
            m_edits.emplace(index, std::move(edit));
    }
    Q_EMIT changed(index);
}

void StagedEdits::setIncluded(ParameterIndex index, bool included)
{
    const auto set = [included](StagedEdit &edit) {
        edit.included = included;
        edit.confirmed = edit.confirmed || included;
    };
    if (const auto staged = m_edits.find(index); staged != m_edits.end())
        set(staged->second);
    if (m_typing == index)
        set(m_typed);
    Q_EMIT changed(index);
}

void StagedEdits::confirm(ParameterIndex index)
{
    endTyping(true);
    setIncluded(index, true);
}

std::optional<double> StagedEdits::unconfirmed(ParameterIndex index) const
{
    const StagedEdit *edit = find(index);
    return edit && edit->value.raw && !edit->confirmed ? leap(parameter(index), known(index), *edit->value.raw)
                                                       : std::nullopt;
}

bool StagedEdits::isIncluded(ParameterIndex index) const
{
    const StagedEdit *edit = find(index);
    return edit && edit->value.raw && edit->included && !unconfirmed(index);
}

const StagedEdit *StagedEdits::find(ParameterIndex index) const
{
    if (m_typing == index)
        return isSettled(index, m_typed) ? nullptr : &m_typed;
    const auto staged = m_edits.find(index);
    return staged == m_edits.end() ? nullptr : &staged->second;
}

std::map<ParameterIndex, StagedEdit> StagedEdits::effective() const
{
    auto edits = m_edits;
    if (!m_typing)
        return edits;
    if (isSettled(*m_typing, m_typed))
        edits.erase(*m_typing);
    else
        edits[*m_typing] = m_typed;
    return edits;
}

std::vector<StagedChange> StagedEdits::ordered() const
{
    ParameterStore inForce(m_family.parameters);
    std::vector<ParameterChange> writes;
    for (const auto &[index, edit] : effective()) {
        if (!edit.value.raw)
            continue;
        writes.push_back({index, *edit.value.raw});
        if (const auto before = known(index))
            inForce.setRead(index, *before);
    }
    arrangeForWriting(m_family, inForce, writes);
    std::vector<StagedChange> changes;
    for (const ParameterChange &write : writes)
        changes.push_back({write.index, known(write.index), write.raw});
    return changes;
}

std::vector<ParameterIndex> StagedEdits::illegal() const
{
    std::vector<ParameterIndex> indices;
    for (const auto &[index, edit] : effective()) {
        if (!edit.value.raw)
            indices.push_back(index);
    }
    return indices;
}

std::vector<ParameterChange> StagedEdits::toWrite() const
{
    std::vector<ParameterChange> changes;
    for (const StagedChange &change : ordered()) {
        if (isIncluded(change.index))
            changes.push_back({change.index, change.to});
    }
    return changes;
}

} // namespace mb
