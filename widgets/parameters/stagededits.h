// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/writeorder.h"
#include "widgets/parameters/valuetext.h"

#include <QObject>
#include <QUndoStack>

#include <map>

namespace mb {

/// One value that is not written yet, legal or not.
struct StagedEdit {
    QString text; ///< as it stands in the field
    ParsedValue value;
    bool included = true;   ///< goes along with the next write
    bool confirmed = false; ///< somebody looked at it once more
    int place = 0;          ///< grows with each edit: which came after which
};

/// What a user wants to change in one device: survives snapshots, other selections and failed writes. An edit that says
/// what the device has anyway is none. Every step can be undone until settle() says that it was written: the unit's own
/// history takes that back.
class StagedEdits : public QObject {
    Q_OBJECT
public:
    explicit StagedEdits(const Family &family, QObject *parent = nullptr);

    /// What the device has now; drops the edits that came true.
    void setEntries(std::span<const ParameterStore::Entry> entries);
    [[nodiscard]] const std::vector<ParameterStore::Entry> &entries() const { return m_entries; }
    [[nodiscard]] const Parameter &parameter(ParameterIndex index) const { return m_family.parameters[index.value]; }
    /// The value in force, when it is known.
    [[nodiscard]] std::optional<std::int64_t> known(ParameterIndex index) const;

    /// The text of a field that is being edited stands before what is staged, without a step of undo.
    void type(ParameterIndex index, const QString &text);
    /// Stages what was typed, or forgets it.
    void endTyping(bool keep);
    [[nodiscard]] std::optional<ParameterIndex> typing() const { return m_typing; }

    void stage(ParameterIndex index, const QString &text);
    /// Several at once, as one step named `title`.
    void stageAll(const std::vector<ParameterChange> &changes, const QString &title);
    void revert(ParameterIndex index);
    void discard();
    /// After a write: what was sent is not an edit any more, unless it was changed since.
    void settle(const std::vector<ParameterChange> &sent);
    /// Ticked by hand: it was looked at, too.
    void setIncluded(ParameterIndex index, bool included);
    /// The factor of a gain that makes a leap (see leap()) and that nobody has confirmed; it is not written until then.
    [[nodiscard]] std::optional<double> unconfirmed(ParameterIndex index) const;
    void confirm(ParameterIndex index);
    /// Legal, ticked and, where it has to be, confirmed.
    [[nodiscard]] bool isIncluded(ParameterIndex index) const;

    [[nodiscard]] const StagedEdit *find(ParameterIndex index) const;
    [[nodiscard]] int count() const { return static_cast<int>(effective().size()); }
    [[nodiscard]] int faults() const { return static_cast<int>(illegal().size()); }
    /// Every legal change in the order of writing (arrangeForWriting()), those that are left out too.
    [[nodiscard]] std::vector<StagedChange> ordered() const;
    /// The edits that cannot be written, in table order.
    [[nodiscard]] std::vector<ParameterIndex> illegal() const;
    /// What a write sends now: legal, included, in order.
    [[nodiscard]] std::vector<ParameterChange> toWrite() const;
    [[nodiscard]] QUndoStack &undoStack() { return m_undo; }
    /// It is this that undo takes back, and nothing of the unit.
    [[nodiscard]] bool canUndo() const { return m_undo.canUndo(); }

Q_SIGNALS:
    /// The edit of one parameter came, went or changed.
    void changed(mb::ParameterIndex index);

private:
    class Step;
    [[nodiscard]] std::map<ParameterIndex, StagedEdit> effective() const;
    void push(ParameterIndex index, const QString &text, QUndoCommand *macro = nullptr);
    void put(ParameterIndex index, const std::optional<QString> &text);
    [[nodiscard]] bool isSettled(ParameterIndex index, const StagedEdit &edit) const;

    const Family &m_family;
    std::vector<ParameterStore::Entry> m_entries;
    std::map<ParameterIndex, StagedEdit> m_edits;
    std::optional<ParameterIndex> m_typing;
    StagedEdit m_typed;
    int m_places = 0;
    QUndoStack m_undo;
};

} // namespace mb
