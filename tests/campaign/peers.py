# SPDX-License-Identifier: MIT
"""A server and those who call it: random requests and messages, slow and vanishing peers, desks that find no thread."""
import base64
import json
import os
import re
import resource
import signal
import socket
import struct
import time
from contextlib import contextmanager

from common import Unexpected, ends_within, require
from limits import NOBODY


class Server:
    def __init__(self, process):
        self.process = process
        line = process.stdout.readline().decode()
        found = re.match(r"http://127\.0\.0\.1:(\d+)/#k=([0-9a-f]{32})", line)
        require(found, f"no link: {line!r}")
        self.port, self.token = int(found[1]), found[2]
        self.host = f"127.0.0.1:{self.port}"

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=20)

    def ask(self, data, patience=20):
        """The first bytes of the answer; empty: closed without one."""
        with self.connect() as link:
            link.settimeout(patience)
            try:
                link.sendall(data)
                link.shutdown(socket.SHUT_WR)
                return link.recv(65536)
            except (ConnectionError, BrokenPipeError):
                return b""
            except TimeoutError:
                raise Unexpected(f"no answer within {patience} s to {data[:200]!r}") from None

    def request(self, method, path, body=b"", token=True, headers=""):
        head = f"{method} {path} HTTP/1.1\r\nHost: {self.host}\r\n{headers}"
        if token:
            head += f"Authorization: Bearer {self.token}\r\n"
        if body:
            head += f"Content-Length: {len(body)}\r\n"
        return head.encode() + b"\r\n" + body

    def require_well(self, what):
        require(self.process.poll() is None, f"the server ended with {self.process.returncode} after {what}")
        answer = self.ask(self.request("GET", "/state"))
        require(answer.startswith(b"HTTP/1.1 200"), f"/state says {answer[:80]!r} after {what}")

    def visit(self, hello=None):
        """A WebSocket after its handshake, said hello; None: refused."""
        link = self.connect()
        key = base64.b64encode(os.urandom(16)).decode()
        link.sendall((f"GET /socket HTTP/1.1\r\nHost: {self.host}\r\nOrigin: http://{self.host}\r\nUpgrade: websocket\r\n"
                      f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"
                      "Sec-WebSocket-Protocol: pabd.1\r\n\r\n").encode())
        if not link.recv(4096).startswith(b"HTTP/1.1 101"):
            link.close()
            return None
        message(link, json.dumps(hello or {"t": "hello", "token": self.token, "size": [320, 180], "scale": 1,
                                           "id": os.urandom(8).hex()}).encode())
        return link


def message(link, payload, opcode=1, final=True):
    head = bytes([(0x80 if final else 0) | opcode])
    n = len(payload)
    head += bytes([0x80 | n]) if n < 126 else bytes([0xFE]) + struct.pack(">H", n) if n < 65536 else bytes([0xFF]) + struct.pack(">Q", n)
    mask = os.urandom(4)
    link.sendall(head + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload)))


@contextmanager
def server(case, *arguments, **options):
    process = case.start(["serve", "two_boxes", "--port", "0", "--quiet", *arguments], **options)
    try:
        yield Server(process)
        process.send_signal(signal.SIGTERM)
        seconds = ends_within(process, 20, "SIGTERM")
        require(process.returncode == 0, f"the server ended with {process.returncode}")
        require(seconds < 2.5, f"SIGTERM took {seconds:.1f} s")
    finally:
        if process.poll() is None:
            process.kill()
            process.communicate()


HEADERS = ["Content-Length: -1", "Content-Length: 99999999999999999999", "Content-Length: 5\r\nContent-Length: 6",
           "Transfer-Encoding: xchunked", "Transfer-Encoding: chunked", "Transfer-Encoding: chunked\r\nContent-Length: 4",
           "Expect: 100-continue", "Upgrade: websocket\r\nConnection: Upgrade", "Host: evil.org", "Origin: null", "Range: bytes=0-",
           "Connection: close, keep-alive", "A: " + "b" * 17000, "A b: c", ": x", "\x00: \x00", "Authorization: Bearer " + "0" * 32]
PATHS = ["/", "/state", "/events", "/frame.png?width=64&height=64", "/frame.png?width=4096", "/files", "/files/a.json", "/files/..%2f..%2fetc",
         "/files/%00", "/actions", "/socket", "//", "/%", "*", "/" + "a" * 9000, "http://a/", "/files/a?b#c", "/page.js"]


def requests(case):
    """Random HTTP in front of a server that goes on answering."""
    r = case.random
    with server(case, "--play") as peer:
        for _ in range(60):
            method = r.choice(["GET", "PUT", "POST", "DELETE", "HEAD", "OPTIONS", "G E T", "", "\xff"])
            body = r.choice([b"", b"{}", b"[]", os.urandom(r.randrange(300)), b'[{"do": "play"}]', b'[{"do":' * 50])
            data = peer.request(method, r.choice(PATHS), body, r.random() < 0.7, r.choice(["", r.choice(HEADERS) + "\r\n"]))
            if r.random() < 0.4:  # a byte flipped, cut or doubled
                k = r.randrange(len(data))
                data = r.choice([data[:k], data[:k] + bytes([r.randrange(256)]) + data[k + 1:], data + data[k:]])
            if b"/events" in data and b"GET" in data:
                continue  # which has no end
            answer = peer.ask(data)
            status = re.match(rb"HTTP/1.1 (\d{3}) ", answer)
            require(not answer or (status and int(status[1]) < 600), f"{answer[:60]!r} to {data[:200]!r}")
            require(not status or int(status[1]) != 500, f"status 500 to {data[:300]!r}")
        peer.require_well("requests")


WORDS = ["hello", "move", "button", "wheel", "key", "text", "leave", "size", "clipboard", "ack", "ask_control", "give_control",
         "quality", "open", "script", "ping", "x", None, 7]
VALUES = [0, -1, 1e308, 1e-320, 0.5, True, None, "", "a" * 500, "left", "auto", [], [1, 2], {}, "\u202e", 2**53, "two_boxes", "Escape"]


def messages(case):
    """Random WebSocket messages: refused, or done, and nobody else notices."""
    r = case.random
    with server(case, "--play") as peer:
        other = peer.visit()
        for _ in range(4):
            link = peer.visit()
            require(link, "no WebSocket")
            try:
                for _ in range(r.randrange(5, 60)):
                    kind = r.random()
                    if kind < 0.75:
                        said = {"t": r.choice(WORDS), **{key: r.choice(VALUES) for key in r.sample(
                            ["x", "y", "b", "down", "mods", "key", "repeat", "s", "size", "scale", "text", "frame", "shown_ms", "mode", "name", "actions", "at"],
                            r.randrange(8))}}
                        message(link, json.dumps(said).encode())
                    elif kind < 0.9:
                        message(link, os.urandom(r.randrange(400)), r.choice([0, 1, 2, 9, 10, 3]), r.random() < 0.8)
                    else:
                        link.sendall(os.urandom(r.randrange(1, 40)))
            except OSError:
                pass  # it was closed, which is an answer
            link.close()
        require(other.recv(1), "the other visitor was sent away")
        other.close()
        peer.require_well("messages")


def slow(case):
    """Peers that send a byte at a time, never read, or say nothing keep nobody else out."""
    r = case.random
    with server(case, "--play") as peer:
        held = []
        for _ in range(12):
            link = peer.connect()
            held.append(link)
            kind = r.randrange(5)
            if kind == 0:
                link.sendall(b"GET / HT")
            elif kind == 1:
                link.sendall(peer.request("PUT", "/files/a.json", headers="Content-Length: 100000\r\n") + b"{")
            elif kind == 2:
                link.sendall(peer.request("GET", "/events"))
            elif kind == 3:
                link.sendall(peer.request("GET", "/frame.png?width=2048&height=2048") * 4)
            else:
                visitor = peer.visit()
                if visitor:
                    held.append(visitor)
        begin = time.monotonic()
        peer.require_well("slow peers")
        require(time.monotonic() - begin < 10, f"an answer took {time.monotonic() - begin:.1f} s")
        for link in held:
            if r.random() < 0.5:  # with a reset
                link.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            link.close()
        peer.require_well("peers that left")


def sessions(case):
    """One session each, some without a thread, a process or memory for it: the visitor is told, the server lives."""
    r = case.random
    options = {}
    kind = r.choice(["processes", "memory", "descriptors", "none"])
    if kind == "processes" and os.getuid() == 0:
        case.folder.chmod(0o777)
        options = {"limits": [(resource.RLIMIT_NPROC, r.randrange(2, 30))], "user": NOBODY}
    elif kind == "memory":
        options = {"limits": [(resource.RLIMIT_AS, r.randrange(400, 2500) << 20)]}
    elif kind == "descriptors":
        options = {"limits": [(resource.RLIMIT_NOFILE, r.randrange(20, 60))]}
    with server(case, "--sessions", "4", "--play", "--threads", "4", **options) as peer:
        visitors = []
        for _ in range(5):
            try:
                visitors.append(peer.visit())
            except OSError:
                pass
            time.sleep(r.uniform(0.02, 0.5))
        for link in filter(None, visitors):
            link.settimeout(40)
            try:
                require(link.recv(1), "a visitor was told nothing")
            except TimeoutError:
                raise Unexpected(f"a visitor waited 40 s ({kind}: {options.get('limits')})") from None
            except ConnectionError:
                pass
            link.close()
        require(peer.process.poll() is None, f"the server ended with {peer.process.returncode} ({kind}: {options.get('limits')})")


def killed_server(case):
    """The next server removes the files of one that was killed, and leaves those of one that lives."""
    def folders():
        return {path.name for path in case.folder.glob(".pabd-serve-*")}
    environment = {"TMPDIR": str(case.folder)}
    with server(case, environment=environment) as living:
        kept = folders()
        killed = case.start(["serve", "two_boxes", "--port", "0", "--quiet"], environment=environment)
        Server(killed)
        killed.kill()
        killed.communicate()
        require(len(folders()) == 2, f"two servers have {folders()}")
        with server(case, environment=environment):
            require(kept < folders() and len(folders()) == 2, f"after {kept} there are {folders()}")
        require(folders() == kept, f"left {folders() - kept}")
        living.require_well("others")
    require(not folders(), f"left {folders()}")
