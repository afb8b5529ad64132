package org.starl.cli.report;

import java.util.List;
import java.util.Map;
import org.starl.sim.net.NetStatistics;

/** The messages by channel, and the dropped copies by cause. */
final class MessagesPart {

  private static final double BYTES_PER_KB = 1e3;

  private final Html html;
  private final Report report;

  MessagesPart(Html html, Report report) {
    this.html = html;
    this.report = report;
  }

  void write() {
    NetStatistics net = sum();
    if (net.sent() == 0) {
      return;
    }
    int runs = report.facts().size();
    html.open("section").element("h2", "Messages");
    html.element(
        "p",
        NumberFormats.count(net.sent())
            + " datagrams were sent in "
            + NumberFormats.count(runs, "run")
            + " ("
            + NumberFormats.number(Math.rint((double) net.sent() / runs))
            + " a run, "
            + NumberFormats.number("bytes", Math.rint((double) net.sentBytes() / net.sent()))
            + " each). Each recipient of a datagram has its own copy: "
            + NumberFormats.count(net.delivered())
            + " copies arrived, "
            + NumberFormats.count(net.lost())
            + " ("
            + NumberFormats.percent(net.lost(), net.lost() + net.delivered())
            + ") were lost.");
    MessageCounts messages = report.messages();
    html.open("div", "class", "charts");
    channels(messages);
    causes(messages);
    html.close().close();
  }

  private NetStatistics sum() {
    long sent = 0;
    long bytes = 0;
    long delivered = 0;
    long lost = 0;
    for (RunFacts run : report.facts().values()) {
      sent += run.network().sent();
      bytes += run.network().sentBytes();
      delivered += run.network().delivered();
      lost += run.network().lost();
    }
    return new NetStatistics(sent, bytes, delivered, lost);
  }

  private void channels(MessageCounts messages) {
    if (messages.channels().isEmpty()) {
      return;
    }
    long most =
        messages.channels().values().stream()
            .mapToLong(MessageCounts.Channel::sent)
            .max()
            .orElse(1);
    html.table("bars", "By channel", List.of("channel", "sent", "", "kB", "received"));
    for (Map.Entry<String, MessageCounts.Channel> entry : messages.channels().entrySet()) {
      MessageCounts.Channel channel = entry.getValue();
      html.open("tr").open("th", "scope", "row").element("code", entry.getKey()).close();
      html.element("td", NumberFormats.count(channel.sent()), "class", "n");
      bar(channel.sent(), most);
      html.element("td", NumberFormats.number(channel.sentBytes() / BYTES_PER_KB), "class", "n");
      html.element("td", NumberFormats.count(channel.delivered()), "class", "n").close();
    }
    html.endTable();
  }

  private void causes(MessageCounts messages) {
    if (messages.dropped().isEmpty()) {
      return;
    }
    long most = messages.dropped().values().stream().mapToLong(Long::longValue).max().orElse(1);
    html.table("bars", "Copies not delivered", List.of("cause", "copies", ""));
    messages
        .dropped()
        .forEach((why, count) -> {
          html.open("tr").open("th", "scope", "row").element("code", why).close();
          html.element("td", NumberFormats.count(count), "class", "n");
          bar(count, most);
          html.close();
        });
    html.endTable();
  }

  /** A bar in a cell of its own. Screen readers skip it: the number is in another cell. */
  private void bar(long value, long most) {
    html.open("td", "class", "bar", "aria-hidden", "true");
    html.open("svg", "viewBox", "0 0 100 10", "preserveAspectRatio", "none");
    String width = Plot.px(100.0 * value / Math.max(1, most));
    html.empty("rect", "class", "bar", "width", width, "height", "10").close().close();
  }
}
