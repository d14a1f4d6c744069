// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/savedlimits.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"

#include <QComboBox>
#include <QCompleter>
#include <QLineEdit>

namespace mb {

SavedLimits::SavedLimits(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    auto *row = layoutIn<QHBoxLayout>(this, theme.theme().u(8));
    m_names = new QComboBox(this);
    m_names->setEditable(true);
    m_names->setInsertPolicy(QComboBox::NoInsert);
    m_names->setCompleter(nullptr); // a name that begins like another is another
    m_names->setAccessibleName(tr("Kept limits"));
    m_names->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_names->lineEdit()->setPlaceholderText(tr("kept limits"));
    m_names->lineEdit()->setAccessibleName(tr("Name of the limits"));
    m_names->setToolTip(
        tr("Choose limits that were kept for this unit, or type a name to keep the present ones under"));
    m_keep = new CommandButton(theme, tr("Keep"), this);
    m_keep->setAccessibleName(tr("Keep these limits under this name"));
    m_forget = new CommandButton(theme, tr("Forget"), this);
    m_forget->setAccessibleName(tr("Forget the limits of this name"));
    row->addWidget(m_names, 1);
    row->addWidget(m_keep);
    row->addWidget(m_forget);
    connect(
        m_names, qOverload<int>(&QComboBox::activated), this, [this](int at) { Q_EMIT chosen(m_names->itemText(at)); });
    connect(m_names->lineEdit(), &QLineEdit::textChanged, this, &SavedLimits::follow);
    connect(m_keep, &QPushButton::clicked, this, [this] { Q_EMIT keepRequested(m_names->currentText().trimmed()); });
    connect(
        m_forget, &QPushButton::clicked, this, [this] { Q_EMIT forgetRequested(m_names->currentText().trimmed()); });
    follow();
}

void SavedLimits::setNames(const QStringList &names)
{
    QStringList shown;
    for (int row = 0; row < m_names->count(); ++row)
        shown << m_names->itemText(row);
    if (shown == names)
        return;
    const QString typed = m_names->currentText();
    const QSignalBlocker quiet(m_names);
    m_names->clear();
    m_names->addItems(names);
    m_names->setCurrentIndex(m_names->findText(typed));
    m_names->setEditText(names.contains(typed) ? typed : QString());
    follow();
}

void SavedLimits::follow()
{
    const QString name = m_names->currentText().trimmed();
    m_keep->setEnabled(!name.isEmpty());
    m_forget->setEnabled(m_names->findText(name) >= 0 && !name.isEmpty());
}

} // namespace mb
