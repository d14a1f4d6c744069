// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/addlinkdialog.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/connection/linkoptions.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <algorithm>
#include <optional>

namespace mb {

AddLinkDialog::AddLinkDialog(const std::vector<LinkChoice> &choices, const ThemeSource &theme, QWidget *parent)
    : QDialog(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("addLink"));
    setWindowTitle(tr("Add a link"));
    setAccessibleName(tr("Add a link"));
    auto *column = new QVBoxLayout(this);
    auto *row = new QHBoxLayout;
    row->setSpacing(theme.theme().u(16));
    m_list = new QTreeWidget(this);
    row->addWidget(m_list, 3);
    row->addWidget(buildDetail(theme), 2);
    column->addLayout(row, 1);
    buildFoot(*column, theme);
    buildList();
    setChoices(choices);
    const QSize room = parent ? parent->window()->size() : QSize(1280, 800);
    resize(
        std::min(theme.theme().u(780), room.width() * 9 / 10), std::min(theme.theme().u(520), room.height() * 9 / 10));
}

void AddLinkDialog::buildList()
{
    m_list->setObjectName(QStringLiteral("linkList"));
    m_list->setAccessibleName(tr("Links that can be added"));
    m_list->setHeaderLabels({tr("Link"), tr("State")});
    m_list->setRootIsDecorated(false);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &AddLinkDialog::choose);
    connect(m_list, &QTreeWidget::itemActivated, this, &AddLinkDialog::finish);
}

void AddLinkDialog::setChoices(const std::vector<LinkChoice> &choices)
{
    if (choices == m_choices)
        return;
    const std::optional<LinkChoice> before = current() ? std::optional(*current()) : std::nullopt;
    const int scrolled = m_list->verticalScrollBar()->value();
    QSignalBlocker quiet(m_list);
    m_choices = choices;
    QTreeWidgetItem *const first = fillList();
    for (QTreeWidgetItemIterator item(m_list); before && *item; ++item) {
        const QVariant place = (*item)->data(0, Qt::UserRole);
        if (place.isValid() && m_choices.at(place.toUInt()).isSameAs(*before))
            m_list->setCurrentItem(*item);
    }
    m_list->verticalScrollBar()->setValue(scrolled);
    quiet.unblock();
    if (!before && m_address->text().isEmpty())
        m_list->setCurrentItem(first);
    describe();
    check();
}

/// A branch for each kind, also where it is empty: that nothing is there is an answer.
QTreeWidgetItem *AddLinkDialog::fillList()
{
    m_list->clear();
    QTreeWidgetItem *first = nullptr;
    const QSize row(0, m_theme.theme().u(28));
    using Kind = LinkChoice::Kind;
    for (const Kind kind : {Kind::Can, Kind::Serial, Kind::Spi, Kind::Recording, Kind::Simulated}) {
        auto *branch = new QTreeWidgetItem(m_list, {kindTitle(kind)});
        branch->setFlags(Qt::ItemIsEnabled);
        branch->setFirstColumnSpanned(true);
        branch->setFont(0, m_theme.theme().font(TextRole::Emphasis, font()));
        branch->setSizeHint(0, row);
        for (std::size_t i = 0; i < m_choices.size(); ++i) {
            const LinkChoice &choice = m_choices[i];
            if (choice.kind != kind)
                continue;
            auto *item = new QTreeWidgetItem(branch, {choice.name, choice.isOpen ? tr("open") : choice.state});
            item->setData(0, Qt::UserRole, static_cast<int>(i));
            item->setToolTip(0, choice.name);
            item->setSizeHint(0, row);
            if (!first && choice.openable && !choice.isOpen && kind != Kind::Recording)
                first = item;
        }
        if (branch->childCount() == 0)
            (new QTreeWidgetItem(branch, {tr("none found")}))->setFlags(Qt::NoItemFlags);
    }
    m_list->expandAll();
    return first;
}

QWidget *AddLinkDialog::buildDetail(const ThemeSource &theme)
{
    auto *detail = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(detail, theme.theme().u(8));
    m_name = textLabel({}, TextRole::Title, Tone::Text, detail);
    m_words = textLabel({}, TextRole::Body, Tone::Dim, detail);
    m_command = textLabel({}, TextRole::Raw, Tone::Text, detail);
    m_command->setAccessibleName(tr("Command for a terminal"));
    m_command->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_options = new LinkOptions(detail);
    for (QLabel *label : {m_name, m_words, m_command}) {
        label->setWordWrap(true);
        column->addWidget(label);
    }
    column->addWidget(m_options);
    column->addStretch(1);
    connect(m_options, &LinkOptions::changed, this, &AddLinkDialog::compose);
    return detail;
}

void AddLinkDialog::buildFoot(QVBoxLayout &column, const ThemeSource &theme)
{
    auto *form = new QFormLayout;
    m_address = new QLineEdit(this);
    m_address->setAccessibleName(tr("Address of the link"));
    m_address->setPlaceholderText(QStringLiteral("socketcan:can0"));
    form->addRow(tr("Address"), m_address);
    m_fault = textLabel({}, TextRole::Body, Tone::Danger, this);
    m_fault->setWordWrap(true);
    m_keep = new QCheckBox(tr("Open it at every start"), this);
    m_keep->setChecked(true);
    column.addSpacing(theme.theme().u(8));
    column.addLayout(form);
    column.addWidget(m_fault);
    column.addWidget(m_keep);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel | QDialogButtonBox::Help, this);
    m_open = buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole);
    m_open->setDefault(true);
    column.addWidget(buttons);
    connect(m_address, &QLineEdit::textChanged, this, &AddLinkDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, &AddLinkDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::helpRequested, this, &AddLinkDialog::helpWanted);
}

void AddLinkDialog::setLines(const std::vector<std::pair<QString, QString>> &lines)
{
    m_options->setLines(lines);
}

const LinkChoice *AddLinkDialog::current() const
{
    const QTreeWidgetItem *item = m_list->currentItem();
    const QVariant place = item ? item->data(0, Qt::UserRole) : QVariant();
    return place.isValid() ? &m_choices.at(static_cast<std::size_t>(place.toInt())) : nullptr;
}

void AddLinkDialog::choose()
{
    describe();
    const LinkChoice *choice = current();
    if (choice)
        m_options->setKind(choice->kind);
    m_keep->setEnabled(!choice || choice->kind != LinkChoice::Kind::Recording);
    compose();
}

void AddLinkDialog::describe()
{
    const LinkChoice *choice = current();
    m_name->setText(choice ? choice->name : QString());
    m_words->setText(choice ? choice->words : QString());
    m_words->setVisible(!m_words->text().isEmpty());
    m_command->setText(choice ? choice->command : QString());
    m_command->setVisible(!m_command->text().isEmpty());
    m_options->setVisible(choice && choice->openable && choice->kind != LinkChoice::Kind::Can
        && choice->kind != LinkChoice::Kind::Recording);
}

/// The address of what is chosen, with its options.
void AddLinkDialog::compose()
{
    const LinkChoice *choice = current();
    auto address
        = choice ? LinkAddress::parse(choice->address) : Result<LinkAddress>{fail(Fault::OutOfRange, Message())};
    if (address)
        address->options = m_options->options();
    m_address->setText(address ? qt(address->text()) : QString());
    check();
}

/// Whether it can be opened, and why not, as far as that is known without opening it.
void AddLinkDialog::check()
{
    const LinkChoice *choice = current();
    const QString text = m_address->text().trimmed();
    const bool recording = choice && choice->kind == LinkChoice::Kind::Recording && text.isEmpty();
    const auto address = LinkAddress::parse(text.toStdString());
    QString fault;
    if (!text.isEmpty() && !address)
        fault = errorText(address.error());
    m_fault->setText(fault);
    m_fault->setVisible(!fault.isEmpty());
    m_open->setText(recording ? tr("Choose the file…") : tr("Open"));
    m_open->setEnabled(recording || address.has_value());
}

void AddLinkDialog::finish()
{
    if (!m_open->isEnabled())
        return;
    const QString text = m_address->text().trimmed();
    if (text.isEmpty())
        Q_EMIT recordingWanted();
    else
        Q_EMIT chosen(text, m_keep->isChecked());
    accept();
}

} // namespace mb
