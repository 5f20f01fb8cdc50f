// Sockets of a stand-in that is a service: listening, taking, sending whole, and waiting for what
// comes first.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace standin {

// A listening socket on 127.0.0.1; `port` 0 takes a free one and is set to it. -1 where it cannot.
int listen_tcp(int* port);
// The same for datagrams.
int bind_udp(int* port);
// A UNIX socket that everybody may use, in place of one that was left behind. -1 where it cannot.
int listen_unix(const std::string& path);
// Connects to 127.0.0.1 only, whatever host is named: stand-ins stay on this machine.
int connect_tcp(int port);
// -1 where nobody waits.
int take(int listener);

// Sends all, waiting a second at most; false where the other side is gone or does not read.
bool send_all(int fd, std::string_view bytes);

// Appends what has come; false where the other side is gone.
bool receive(int fd, std::string* bytes);

}  // namespace standin
