// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "storage/sqlconnection.h"

#include <memory>
#include <string>

class QSqlDatabase;

namespace mb {

/// The user's one SQLite file: a connection with the newest schema. Of the thread that opened it, which needs a
/// QCoreApplication; several programs may have the file open. Reading and writing wait for the disk.
class Database final : public SqlConnection {
public:
    /// Makes file and folder where they are missing, and brings an older schema up to date. A file that is damaged is put aside
    /// beside itself, never deleted, and remark() says so. A file that cannot be written is opened for reading, and
    /// isReadOnly(). NotKept with the cause where it can be neither, or was made by a newer version.
    [[nodiscard]] static Result<std::unique_ptr<Database>> open(const std::string &path);
    ~Database() override;

    [[nodiscard]] const std::string &path() const { return m_path; }
    [[nodiscard]] const std::string &remark() const { return m_remark; }
    [[nodiscard]] bool isReadOnly() const { return m_readOnly; }

    /// NotKept with the cause: a full disk, another program that holds the file for 5 s.
    [[nodiscard]] Result<void> run(
        const char *statement, const QVariantList &values = {}, const Row &row = {}) override;
    /// The number of the row that run() has added last.
    [[nodiscard]] std::int64_t lastRow() const { return m_lastRow; }
    [[nodiscard]] int changed() const override { return m_changed; }
    /// On the disk when it succeeds.
    [[nodiscard]] Result<void> transact(const std::function<Result<void>()> &work) override;

private:
    Database(std::string path, std::string connection);
    [[nodiscard]] QSqlDatabase connection() const;
    [[nodiscard]] Result<void> connect();
    [[nodiscard]] Result<void> prepare();
    [[nodiscard]] Result<void> migrate();
    [[nodiscard]] Result<void> putAside();
    void close();

    std::string m_path;
    std::string m_connection;
    std::string m_remark;
    bool m_readOnly = false;
    std::int64_t m_lastRow = 0;
    int m_lastCode = 0; ///< SQLite's, of what run() has done last
    int m_changed = 0;
};

} // namespace mb
