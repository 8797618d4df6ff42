// SPDX-License-Identifier: MIT
// Tests of the page against a server that only speaks the protocol.
import test from "node:test";

import { MockServer } from "./mock_server.mjs";
import { TEST_LIMIT, close_browser, wait_frame, with_visitor } from "./support.mjs";

export const RED = [200, 30, 40];
export const BLUE = [30, 60, 200];
export const GREEN = [20, 160, 70];

test.after(close_browser);

// A server and a visitor who has seen his first frame; nobody answers for longer than the test. `options.mock`: members
// of the server; `options.no_key`: the visitor comes without one.
export const page_test = (name, options, act) =>
  test(name, { timeout: TEST_LIMIT }, async () => {
    const mock = Object.assign(new MockServer(), options.mock ?? {});
    await mock.start();
    try {
      await with_visitor(options.no_key ? mock.url : mock.link, options, async (page) => {
        if (!options.no_key && !mock.refuse) await wait_frame(page, 1);
        await act(page, mock);
      });
    } finally {
      await mock.stop().catch(() => {});
    }
  });

export const settled = (page) => page.waitForTimeout(120);
