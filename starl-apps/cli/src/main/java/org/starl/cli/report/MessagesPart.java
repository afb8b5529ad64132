package org.starl.cli.report;

import java.util.List;
import java.util.Map;
import org.starl.sim.net.NetStatistics;

/** What went over the air, by channel, and what came to nothing, by its cause. */
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
        Say.count(net.sent())
            + " datagrams were sent in "
            + Say.count(runs, "run")
            + " ("
            + Say.number(Math.rint((double) net.sent() / runs))
            + " a run, "
            + Say.with("bytes", Math.rint((double) net.sentBytes() / net.sent()))
            + " each). Of a datagram every recipient gets a copy, or loses it: "
            + Say.count(net.delivered())
            + " copies arrived, "
            + Say.count(net.lost())
            + " ("
            + Say.percent(net.lost(), net.lost() + net.delivered())
            + ") were lost on the air.");
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
    head("By channel", List.of("channel", "sent", "", "kB", "received"));
    for (Map.Entry<String, MessageCounts.Channel> entry : messages.channels().entrySet()) {
      MessageCounts.Channel channel = entry.getValue();
      html.open("tr").open("th", "scope", "row").element("code", entry.getKey()).close();
      html.element("td", Say.count(channel.sent()), "class", "n");
      bar(channel.sent(), most);
      html.element("td", Say.number(channel.sentBytes() / BYTES_PER_KB), "class", "n");
      html.element("td", Say.count(channel.delivered()), "class", "n").close();
    }
    html.close().close().close();
  }

  private void causes(MessageCounts messages) {
    if (messages.dropped().isEmpty()) {
      return;
    }
    long most = messages.dropped().values().stream().mapToLong(Long::longValue).max().orElse(1);
    head("Copies that came to nothing", List.of("cause", "copies", ""));
    messages
        .dropped()
        .forEach((why, count) -> {
          html.open("tr").open("th", "scope", "row").element("code", why).close();
          html.element("td", Say.count(count), "class", "n");
          bar(count, most);
          html.close();
        });
    html.close().close().close();
  }

  private void head(String caption, List<String> columns) {
    html.open("div", "class", "wide").open("table", "class", "bars").element("caption", caption);
    html.open("thead").open("tr");
    html.element("th", columns.get(0), "scope", "col");
    columns
        .subList(1, columns.size())
        .forEach(column -> html.element("th", column, "scope", "col", "class", "n"));
    html.close().close().open("tbody");
  }

  /** The number stands beside it. */
  private void bar(long value, long most) {
    html.open("td", "class", "bar", "aria-hidden", "true");
    html.open("svg", "viewBox", "0 0 100 10", "preserveAspectRatio", "none");
    String width = Plot.px(100.0 * value / Math.max(1, most));
    html.empty("rect", "class", "bar", "width", width, "height", "10").close().close();
  }
}
