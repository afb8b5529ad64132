package org.starl.cli.report;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.sim.SimObserver;
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
 * runs down. An arrow is a message from its sending to its handler; a cross is a lost one; a box is
 * an action. Heights are in the order of events, not to scale.
 */
public final class SequenceChart implements SimObserver {

  private static final int MOST_ROWS = 60;
  private static final int ROW = 20;
  private static final int LEFT = 80;
  private static final int LANE = 190;
  private static final int HEAD = 40;
  private static final int MOST_CHARACTERS = 28;

  /** What the arrows show already: both ends of a message. */
  private static final Pattern SHOWN = Pattern.compile("(from|to)=[^,\\]]*(, )?");

  private static final String STYLE =
      "text{font:11px sans-serif;fill:#222;paint-order:stroke;stroke:#fff;stroke-width:3px}.time{fill:#777}.lane{stroke:#bbb}.act{fill:#eef3fb;"
          + "stroke:#7a95c4}.msg{stroke:#333;marker-end:url(#head)}.lost{stroke:#c22}.bad{fill:#c22;"
          + "font-weight:bold}.back{fill:#fff}@media(prefers-color-scheme:dark){text{fill:#ddd;stroke:#1b1d21}"
          + ".back{fill:#1b1d21}.lane{stroke:#555}.act{fill:#26324a}.msg{stroke:#ccc}}";

  private final ArrayDeque<TraceEvent> last = new ArrayDeque<>();
  private final List<TraceEvent> kept = new ArrayList<>();
  private String problem = "";

  @Override
  public void observed(TraceEvent event) {
    boolean isShown =
        event instanceof Sent
            || event instanceof Delivered
            || event instanceof Action
            || event instanceof Dropped
            || (event instanceof Fault fault
                && (fault.name().equals(Fault.CRASH) || fault.name().equals(Fault.RESTART)));
    if (isShown && problem.isEmpty()) {
      last.add(event);
      if (last.size() > 4 * MOST_ROWS) {
        last.remove();
      }
    }
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    if (problem.isEmpty()) {
      problem = violation.toString();
      keep(violation.robots());
    }
  }

  /** Ends the chart at this problem, unless a specification was violated before. */
  public void end(String newProblem) {
    if (problem.isEmpty()) {
      problem = newProblem;
      keep(List.of());
    }
  }

  /** Keeps the events of the culprits, and of the robots that they exchange messages with. */
  private void keep(Collection<RobotId> culprits) {
    for (TraceEvent event : last) {
      if (culprits.isEmpty()
          || culprits.contains(event.robot())
          || (event instanceof Delivered message && culprits.contains(message.from()))
          || (event instanceof Sent message && isTo(message.to(), culprits))) {
        kept.add(event);
      }
    }
    if (kept.size() > MOST_ROWS) {
      kept.subList(0, kept.size() - MOST_ROWS).clear();
    }
  }

  private static boolean isTo(String to, Collection<RobotId> robots) {
    return to.equals("*") || robots.stream().anyMatch(robot -> robot.name().equals(to));
  }

  /** Whether there is no problem, or no event before it. */
  public boolean isEmpty() {
    return kept.isEmpty();
  }

  /** The whole picture. */
  public String svg() {
    Map<String, Integer> lanes = lanes();
    int width = LEFT + LANE * Math.max(1, lanes.size()) + LANE / 2;
    int height = HEAD + ROW * (kept.size() + 3);
    StringBuilder svg = new StringBuilder();
    svg.append(
        ("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\""
                + " height=\"%d\"><style>%s</style><defs><marker id=\"head\" viewBox=\"0 0 8 8\""
                + " refX=\"7\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">"
                + "<path d=\"M0 0L8 4L0 8z\" fill=\"#777\"/></marker></defs>"
                + "<rect class=\"back\" width=\"%d\" height=\"%d\"/>")
            .formatted(width, height, width, height, STYLE, width, height));
    lanes.forEach((robot, x) -> {
      svg.append(
          "<line class=\"lane\" x1=\"%d\" x2=\"%d\" y1=\"%d\" y2=\"%d\"/>"
              .formatted(x, x, HEAD - 10, height - 2 * ROW));
      text(svg, x, HEAD - 18, "text-anchor=\"middle\"", robot, robot);
    });
    rows(svg, lanes);
    text(svg, 8, height - ROW, "class=\"bad\"", problem, problem);
    return svg.append("</svg>").toString();
  }

  /** The x of each robot's line, in the order of names. */
  private Map<String, Integer> lanes() {
    Set<String> robots = new LinkedHashSet<>();
    kept.stream().map(event -> event.robot().name()).sorted().forEach(robots::add);
    Map<String, Integer> lanes = new LinkedHashMap<>();
    for (String robot : robots) {
      lanes.put(robot, LEFT + LANE / 2 + LANE * lanes.size());
    }
    return lanes;
  }

  private void rows(StringBuilder svg, Map<String, Integer> lanes) {
    Map<String, Integer> sentAt = new LinkedHashMap<>();
    int y = HEAD;
    long shownMs = -1;
    for (TraceEvent event : kept) {
      y += ROW;
      long ms = event.timeNs() / Time.NS_PER_MS;
      if (ms != shownMs) {
        shownMs = ms;
        String time = String.format(Locale.ROOT, "%d.%03d s", ms / 1000, ms % 1000);
        text(svg, 4, y + 4, "class=\"time\"", time, time);
      }
      int x = lanes.getOrDefault(event.robot().name(), LEFT);
      switch (event) {
        case Sent sent -> {
          sentAt.put(sent.robot() + "/" + sent.seq(), y);
          svg.append("<circle cx=\"%d\" cy=\"%d\" r=\"2.5\" fill=\"#777\"/>".formatted(x, y));
        }
        case Delivered message -> {
          Integer fromY = sentAt.get(message.from() + "/" + message.seq());
          Integer fromX = lanes.get(message.from().name());
          arrow(svg, fromX == null ? x - LANE / 2 : fromX, fromY == null ? y - ROW : fromY, x, y);
          label(svg, x + 6, y - 3, message.message().toString());
        }
        case Dropped dropped -> {
          svg.append("<path class=\"lost\" d=\"M%d %dl8 8m0 -8l-8 8\"/>".formatted(x - 4, y - 4));
          label(svg, x + 8, y + 4, dropped.why() + ", from " + dropped.from());
        }
        case Fault fault -> label(svg, x + 6, y + 4, fault.name() + " " + fault.detail());
        case Action action -> action(svg, x, y, action);
        default -> throw new IllegalStateException("not shown: " + event);
      }
    }
  }

  private static void arrow(StringBuilder svg, int fromX, int fromY, int toX, int toY) {
    svg.append(
        "<line class=\"msg\" x1=\"%d\" y1=\"%d\" x2=\"%d\" y2=\"%d\"/>"
            .formatted(fromX, fromY, toX, toY));
  }

  private static void action(StringBuilder svg, int x, int y, Action action) {
    String words =
        action.args().stream()
            .map(String::valueOf)
            .collect(Collectors.joining(", ", action.name() + "(", ")"));
    svg.append(
        "<rect class=\"act\" x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"3\"/>"
            .formatted(x - LANE / 2 + 8, y - 8, LANE - 16, ROW - 4));
    text(svg, x, y + 4, "text-anchor=\"middle\"", words, action.source() + ": " + words);
  }

  private static void label(StringBuilder svg, int x, int y, String words) {
    text(svg, x, y, "", words, words);
  }

  /** Text, cut to its place unless it is the problem; the whole of it when pointed at. */
  private static void text(
      StringBuilder svg, int x, int y, String attributes, String words, String whole) {
    String brief = SHOWN.matcher(words).replaceAll("");
    boolean isCut = brief.length() > MOST_CHARACTERS && !attributes.contains("bad");
    String shown = isCut ? brief.substring(0, MOST_CHARACTERS - 1) + "\u2026" : brief;
    svg.append("<text x=\"%d\" y=\"%d\" %s>".formatted(x, y, attributes))
        .append(escaped(shown))
        .append("<title>")
        .append(escaped(whole))
        .append("</title></text>");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }
}
