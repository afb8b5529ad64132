package org.starl.spec;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * The specification of sealed datagrams. {@code Authentic}: every message that a robot handles was
 * sent with this content by the robot that it names, to this robot or to all, since the latest start
 * of both, and is handled once. So a forged, changed or replayed datagram has no effect, nor has a
 * second copy of a genuine one.
 */
public final class Authentic extends LemmaMonitor {

  private static final String AUTHENTIC = "datagrams.Authentic";

  /** What each robot has sent since its latest start, by the datagrams' numbers. */
  private final Map<RobotId, Map<Long, Sent>> sent = new TreeMap<>();

  /** What each robot has handled since its latest start: the numbers, by sender. */
  private final Map<RobotId, Map<RobotId, Set<Long>>> handled = new TreeMap<>();

  private final Map<RobotId, Long> startedNs = new TreeMap<>();
  private boolean hasSent;

  public Authentic() {
    lemma(AUTHENTIC, "Every message that is handled was sent to this robot, and arrives once.");
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    switch (event) {
      case Sent datagram -> {
        hasSent = true;
        // A body that leaves the floor says nothing of its program; numbers begin with a program.
        if (datagram.seq() == 1 && sent.containsKey(datagram.robot())) {
          started(datagram);
        }
        sent.computeIfAbsent(datagram.robot(), robot -> new TreeMap<>())
            .put(datagram.seq(), datagram);
      }
      case Delivered datagram -> check(datagram, report);
      case Fault fault when fault.name().equals(Fault.RESTART) -> started(fault);
      default -> {}
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    if (!hasSent) {
      never(AUTHENTIC, "no robot sends messages");
    }
  }

  private void started(TraceEvent event) {
    RobotId robot = event.robot();
    startedNs.put(robot, event.timeNs());
    sent.remove(robot);
    handled.remove(robot);
    handled.values().forEach(bySender -> bySender.remove(robot));
  }

  private void check(Delivered datagram, Report report) {
    report.checked(AUTHENTIC);
    RobotId from = datagram.from();
    Sent original = sent.getOrDefault(from, Map.of()).get(datagram.seq());
    boolean isFirst =
        handled
            .computeIfAbsent(datagram.robot(), robot -> new TreeMap<>())
            .computeIfAbsent(from, sender -> new TreeSet<>())
            .add(datagram.seq());
    String wrong = isGenuine(datagram, original) ? isFirst ? "" : "a replayed" : "a forged";
    if (!wrong.isEmpty()) {
      String detail =
          "handles "
              + wrong
              + (" datagram, number " + datagram.seq() + " of " + from)
              + (" on " + datagram.channel() + ": " + datagram.message());
      report.violated(AUTHENTIC, datagram.timeNs(), List.of(datagram.robot()), detail);
    }
  }

  private boolean isGenuine(Delivered datagram, @Nullable Sent original) {
    RobotId receiver = datagram.robot();
    return original != null
        && original.channel().equals(datagram.channel())
        && original.message().equals(datagram.message())
        && (original.to().equals(Sent.ALL) || original.to().equals(receiver.name()))
        && original.timeNs() >= startedNs.getOrDefault(receiver, 0L);
  }
}
