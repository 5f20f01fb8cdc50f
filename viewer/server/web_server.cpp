#include "viewer/server/web_server.h"

#include <utility>

#include "viewer/server/detail/page.h"
#include "viewer/server/detail/web_core.h"
#include "viewer/server/origin.h"
#include <boost/asio/post.hpp>

namespace thigma::live {

struct WebServer::Impl {
  Core core;
};

WebServer::WebServer(const WebAddress& address, std::vector<WebFile> files, const WebLimits& limits)
    : impl_(new Impl{{address, std::move(files), limits}}) {}

WebServer::~WebServer() {
  stop();
  impl_->core.pages.clear();
}

std::uint16_t WebServer::port() const noexcept { return impl_->core.port; }

std::string WebServer::address() const {
  const WebAddress& at = impl_->core.address;
  return "http://" + host_of(at.bind) + ":" + std::to_string(impl_->core.port) +
         (at.token.empty() ? "" : "/#token=" + at.token);
}

void WebServer::start(WebHandlers handlers) {
  impl_->core.handlers = std::move(handlers);
  impl_->core.accept();
  impl_->core.arm_tick();
  impl_->core.thread = std::thread([this] { impl_->core.io.run(); });
}

void WebServer::stop() {
  if (!impl_->core.thread.joinable()) return;
  asio::post(impl_->core.io, [this] { impl_->core.begin_stop(); });
  impl_->core.thread.join();
}

void WebServer::post(std::function<void()> work) { asio::post(impl_->core.io, std::move(work)); }

void WebServer::send(PageId page, std::string message, bool is_binary) {
  const auto found = impl_->core.pages.find(page);
  if (found == impl_->core.pages.end()) return;
  const std::shared_ptr<Page> kept = found->second;
  kept->send(std::move(message), is_binary);
}

bool WebServer::offer(PageId page, std::span<const std::string> messages) {
  const auto found = impl_->core.pages.find(page);
  return found != impl_->core.pages.end() && found->second->offer(messages);
}

std::size_t WebServer::waiting_bytes(PageId page) const {
  const auto found = impl_->core.pages.find(page);
  return found == impl_->core.pages.end() ? 0 : found->second->waiting_bytes();
}

std::uint64_t WebServer::dropped(PageId page) const {
  const auto found = impl_->core.pages.find(page);
  return found == impl_->core.pages.end() ? 0 : found->second->dropped;
}

std::vector<PageId> WebServer::pages() const {
  std::vector<PageId> ids;
  for (const auto& [id, page] : impl_->core.pages) ids.push_back(id);
  return ids;
}

bool WebServer::may_control(PageId page) const {
  const auto found = impl_->core.pages.find(page);
  return found != impl_->core.pages.end() && found->second->may_control();
}

}  // namespace thigma::live
