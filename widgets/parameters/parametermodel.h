// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"
#include "widgets/parameters/parametergroups.h"
#include "widgets/parameters/stagededits.h"

#include <QAbstractItemModel>
#include <QPointer>

#include <vector>

namespace mb {

/// What the values are compared with: defaults, what was found first, or a file.
struct ParameterReference {
    QString title;                                 ///< head of its column
    std::vector<std::optional<std::int64_t>> raws; ///< in table order; nothing where it says nothing
};
[[nodiscard]] ParameterReference defaultsOf(const Family &family);

/// The shape of what is known of a value.
[[nodiscard]] GlyphState glyphOf(ParameterState state);

/// How one value stands, as shape, word and colour.
struct ParameterStanding {
    GlyphState glyph = GlyphState::Waiting;
    QString text;
    bool edited = false;
    bool illegal = false;
    bool changed = false;            ///< differs from the reference
    bool unread = false;             ///< the device gave no answer for it
    std::optional<std::int64_t> raw; ///< as shown: the edit's, else the device's
};

/// Groups, their parameters, and below a parameter that has an illegal edit one row for the fault. Shows the edits of
/// one device; only show() resets, everything else arrives as dataChanged or as the row of a fault, so that an open
/// editor stays.
class ParameterModel : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { Label, Key, ValueColumn, Unit, Reference, State, Raw, ColumnCount };
    enum class Kind { Group, Parameter, Fault };

    using QAbstractItemModel::QAbstractItemModel;

    /// Nothing, a device or a file. `edits` has the values and outlives its showing; the model follows it.
    void show(const Family *family, StagedEdits *edits, bool writable);
    /// After StagedEdits::setEntries().
    void refresh();
    void setReference(ParameterReference reference);
    [[nodiscard]] const ParameterReference &reference() const { return m_reference; }
    [[nodiscard]] const Family *family() const { return m_family; }
    [[nodiscard]] StagedEdits *edits() const { return m_edits; }
    [[nodiscard]] bool isWritable() const { return m_writable; }
    [[nodiscard]] const ParameterGroups &groups() const { return m_groups; }

    [[nodiscard]] static Kind kindOf(const QModelIndex &index);
    /// Of a parameter or of its fault.
    [[nodiscard]] ParameterIndex parameterAt(const QModelIndex &index) const;
    [[nodiscard]] const Parameter &parameter(ParameterIndex index) const { return m_family->parameters[index.value]; }
    [[nodiscard]] QModelIndex indexOf(ParameterIndex index, int column = ValueColumn) const;
    [[nodiscard]] ParameterStanding standing(ParameterIndex index) const;
    /// Toggles what is on or off; nothing for the others.
    void toggle(ParameterIndex index);

    QModelIndex index(int row, int column, const QModelIndex &parent = {}) const override;
    QModelIndex parent(const QModelIndex &child) const override;
    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

Q_SIGNALS:
    /// A value, an edit or the reference changed: counts and filters follow.
    void standingChanged();

private:
    void build();
    void editChanged(ParameterIndex index);
    [[nodiscard]] bool asks(ParameterIndex index) const;
    void touchRow(ParameterIndex index);
    [[nodiscard]] QVariant text(ParameterIndex index, int column) const;
    [[nodiscard]] QString toolTip(ParameterIndex index) const;
    [[nodiscard]] QString faultText(ParameterIndex index) const;

    const Family *m_family = nullptr;
    QPointer<StagedEdits> m_edits;
    bool m_writable = false;
    ParameterReference m_reference;
    ParameterGroups m_groups;
    std::vector<bool> m_faults;                 ///< parameters that have a row for their fault
    std::vector<ParameterStore::Entry> m_shown; ///< what the views were told last
};

} // namespace mb
