package org.starl.sim.view.page;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.SimObserver;
import org.starl.sim.record.MessageText;
import org.starl.spec.SpecReport;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * A message sequence chart of the last events before a problem, as SVG: a line for each robot, time
 * runs down. Each event has a row of its own, so no two cross: an arrow is a message when its handler
 * gets it, an arrow with a cross is a lost one, a box is an action. The last message to a robot of the
 * problem is emphasised. Heights are in the order of events, not to scale.
 */
public final class SequenceChart implements SimObserver {

  private static final int MOST_ROWS = 60;
  private static final int ROW = 24;
  private static final int LEFT = 80;
  private static final int LANE = 190;
  private static final int HEAD = 40;
  private static final int CHARACTER = 6;

  /** What the arrows show already: both ends of a message. */
  private static final Set<String> SHOWN = Set.of("from", "to");

  /** In a page, its colours are the page's. */
  static final String STYLE =
      "svg:root{--ink:#222;--paper:#fff;--muted:#666;--line:#bbb;--alarm:#c02020;--pick:#e4eef6}"
          + "@media(prefers-color-scheme:dark){svg:root{--ink:#ddd;--paper:#1b1d21;--muted:#aaa;--line:#555;"
          + "--alarm:#ff6b60;--pick:#26324a}}.sequence text{font:11px sans-serif;fill:var(--ink);"
          + "paint-order:stroke;stroke:var(--paper);stroke-width:3px}.sequence .time{fill:var(--muted)}"
          + ".sequence .lane{stroke:var(--line)}.sequence .back{fill:var(--paper)}"
          + ".sequence .act{fill:var(--pick);stroke:var(--line)}.sequence .msg{stroke:var(--ink);"
          + "marker-end:url(#sequence-head)}.sequence .head{fill:var(--ink)}.sequence .lost{stroke:var(--alarm);"
          + "stroke-dasharray:4 3;fill:none}.sequence .cross{stroke:var(--alarm);fill:none}"
          + ".sequence .bad{fill:var(--alarm);font-weight:bold}"
          + ".sequence .decisive .msg{stroke-width:3px;stroke:var(--alarm)}"
          + ".sequence .decisive text{font-weight:bold}";

  private static final int SENT_PER_ROW = 100;

  private final int mostRows;
  private final ArrayDeque<TraceEvent> last = new ArrayDeque<>();
  private final List<TraceEvent> kept = new ArrayList<>();
  private final Map<String, Long> sentNs;
  private @Nullable Delivered decisive;
  private String problem = "";

  public SequenceChart() {
    this(MOST_ROWS);
  }

  SequenceChart(int mostRows) {
    this.mostRows = mostRows;
    // A message that is under way for longer shows no beginning.
    sentNs =
        new LinkedHashMap<>() {
          private static final long serialVersionUID = 1;

          @Override
          protected boolean removeEldestEntry(Map.Entry<String, Long> eldest) {
            return size() > SENT_PER_ROW * mostRows;
          }
        };
  }

  @Override
  public void observed(TraceEvent event) {
    if (!problem.isEmpty()) {
      return;
    }
    if (event instanceof Sent sent) {
      sentNs.put(sent.robot() + "/" + sent.seq(), sent.timeNs());
    }
    boolean isShown =
        event instanceof Delivered
            || event instanceof Action
            || event instanceof Dropped
            || (event instanceof Fault fault
                && (fault.name().equals(Fault.CRASH) || fault.name().equals(Fault.RESTART)));
    if (isShown) {
      last.add(event);
      if (last.size() > 4 * mostRows) {
        last.remove();
      }
    }
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    if (problem.isEmpty()) {
      problem = violation.toString();
      keep(violation.robots());
      decide(violation.robots(), violation.timeNs());
    }
  }

  /** Ends the chart at this problem, unless a specification was violated before. */
  public void end(String newProblem) {
    if (problem.isEmpty()) {
      problem = newProblem;
      keep(List.of());
    }
  }

  /** Emphasises the last message to one of these robots until then. */
  void decide(Collection<RobotId> culprits, long untilNs) {
    for (TraceEvent event : kept.isEmpty() ? last : kept) {
      if (event instanceof Delivered message
          && message.timeNs() <= untilNs
          && culprits.contains(message.robot())) {
        decisive = message;
      }
    }
  }

  /** Keeps the events of the culprits, and of the robots that they exchange messages with. */
  private void keep(Collection<RobotId> culprits) {
    for (TraceEvent event : last) {
      if (culprits.isEmpty()
          || culprits.contains(event.robot())
          || (event instanceof Delivered message && culprits.contains(message.from()))) {
        kept.add(event);
      }
    }
    if (kept.size() > mostRows) {
      kept.subList(0, kept.size() - mostRows).clear();
    }
  }

  /** Whether there is no problem, or no event before it. */
  public boolean isEmpty() {
    return kept.isEmpty();
  }

  /** The whole picture. */
  public String svg() {
    Map<String, Integer> lanes = lanes();
    int width = LEFT + LANE * Math.max(1, lanes.size()) + LANE / 2;
    int height = HEAD + ROW * (kept.size() + 2);
    StringBuilder svg = new StringBuilder();
    svg.append(
        ("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"sequence\" viewBox=\"0 0 %d %d\""
                + " width=\"%d\" height=\"%d\"><style>%s</style><defs><marker id=\"sequence-head\""
                + " viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\""
                + " markerUnits=\"userSpaceOnUse\" orient=\"auto\">"
                + "<path class=\"head\" d=\"M0 0L8 4L0 8z\"/></marker></defs>"
                + "<rect class=\"back\" width=\"%d\" height=\"%d\"/>")
            .formatted(width, height, width, height, STYLE, width, height));
    lanes
        .values()
        .forEach(x ->
            svg.append(
                "<line class=\"lane\" x1=\"%d\" x2=\"%d\" y1=\"%d\" y2=\"%d\"/>"
                    .formatted(x, x, HEAD - 10, height - 2 * ROW)));
    int y = HEAD;
    for (TraceEvent event : kept) {
      row(svg, lanes, event, y);
      y += ROW;
    }
    text(svg, 8, height - ROW, " class=\"bad\"", Integer.MAX_VALUE, problem, problem);
    // Last, so that a page can keep them in sight above the rows.
    svg.append(
        "<g class=\"heads\"><rect class=\"back\" width=\"%d\" height=\"%d\"/>"
            .formatted(width, HEAD - 8));
    lanes.forEach(
        (robot, x) -> text(svg, x, HEAD - 18, " text-anchor=\"middle\"", LANE, robot, robot));
    svg.append("</g>");
    return svg.append("</svg>").toString();
  }

  /** The x of each robot's line, in the order of names. */
  private Map<String, Integer> lanes() {
    TreeSet<String> robots = new TreeSet<>();
    for (TraceEvent event : kept) {
      robots.add(event.robot().name());
      String from = from(event);
      if (RobotId.isValid(from)) {
        robots.add(from);
      }
    }
    Map<String, Integer> lanes = new LinkedHashMap<>();
    for (String robot : robots) {
      lanes.put(robot, LEFT + LANE / 2 + LANE * lanes.size());
    }
    return lanes;
  }

  /** The sender of a message; empty if it is none. */
  private static String from(TraceEvent event) {
    return switch (event) {
      case Delivered message -> message.from().name();
      case Dropped message -> message.from();
      default -> "";
    };
  }

  /** One event, in a group that a page may move, hide and click. */
  private void row(StringBuilder svg, Map<String, Integer> lanes, TraceEvent event, int y) {
    String channel = event instanceof Delivered message ? message.channel().name() : "";
    svg.append(
        ("<g class=\"row%s\" transform=\"translate(0,%d)\" data-ms=\"%s\" data-robots=\"%s %s\""
                + " data-channel=\"%s\">")
            .formatted(
                event.equals(decisive) ? " decisive" : "",
                y,
                RunPage.millis(event.timeNs()),
                event.robot(),
                escaped(from(event)),
                escaped(channel)));
    String time = seconds(event.timeNs());
    text(svg, 4, 15, " class=\"time\"", LEFT, time, time);
    int x = lanes.getOrDefault(event.robot().name(), LEFT);
    switch (event) {
      case Delivered message -> {
        Long atNs = sentNs.get(message.from() + "/" + message.seq());
        String sent = atNs == null ? "" : ", sent at " + seconds(atNs);
        MessageText brief = MessageText.of(message.shape(), message.message(), SHOWN);
        arrow(
            svg,
            lanes.getOrDefault(from(event), x),
            x,
            false,
            brief.toString(),
            channel + sent + ": " + message.message());
      }
      case Dropped dropped -> {
        String words = dropped.why() + ", from " + dropped.from();
        arrow(svg, lanes.getOrDefault(from(event), x - LANE / 2), x, true, words, words);
      }
      case Action action -> action(svg, x, action);
      case Fault fault -> {
        String words = fault.name() + " " + fault.detail();
        text(svg, x + 6, 15, " class=\"bad\"", LANE, words, words);
      }
      default -> throw new IllegalStateException("not shown: " + event);
    }
    svg.append("</g>");
  }

  private static String seconds(long timeNs) {
    long ms = timeNs / Time.NS_PER_MS;
    return String.format(Locale.ROOT, "%d.%03d s", ms / 1000, ms % 1000);
  }

  /** From lane to lane, with its words above it; a robot's message to itself begins beside its lane. */
  private static void arrow(
      StringBuilder svg, int from, int toX, boolean isLost, String words, String whole) {
    int fromX = from == toX ? toX - LANE / 2 : from;
    svg.append(
        "<line class=\"%s\" x1=\"%d\" y1=\"17\" x2=\"%d\" y2=\"17\"/>"
            .formatted(isLost ? "lost" : "msg", fromX, toX));
    if (isLost) {
      svg.append("<path class=\"cross\" d=\"M%d 13l8 8m0 -8l-8 8\"/>".formatted(toX - 4));
    }
    int widthPx = Math.abs(toX - fromX) - 16;
    text(svg, (fromX + toX) / 2, 12, " text-anchor=\"middle\"", widthPx, words, whole);
  }

  private static void action(StringBuilder svg, int x, Action action) {
    String words =
        action.args().stream()
            .map(String::valueOf)
            .collect(Collectors.joining(", ", action.name() + "(", ")"));
    svg.append(
        "<rect class=\"act\" x=\"%d\" y=\"3\" width=\"%d\" height=\"%d\" rx=\"3\"/>"
            .formatted(x - LANE / 2 + 8, LANE - 16, ROW - 6));
    String middle = " text-anchor=\"middle\"";
    text(svg, x, 16, middle, LANE - 20, words, action.source() + ": " + words);
  }

  /** Text, cut to its place; the whole of it when pointed at. */
  private static void text(
      StringBuilder svg, int x, int y, String attributes, int widthPx, String words, String whole) {
    int most = Math.max(2, widthPx / CHARACTER);
    String shown = words.length() > most ? words.substring(0, most - 1) + "\u2026" : words;
    svg.append("<text x=\"%d\" y=\"%d\"%s>".formatted(x, y, attributes))
        .append(escaped(shown))
        .append("<title>")
        .append(escaped(whole))
        .append("</title></text>");
  }

  /** For XML, in which "]]>" may not stand. */
  private static String escaped(String text) {
    return RunPage.escaped(text).replace(">", "&gt;");
  }
}
