package org.starl.sim.view;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.sim.record.Flight;
import org.starl.sim.replay.Recording;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;

/**
 * The datagrams in flight at a moment of a recording. Searches backwards for their sending and
 * forwards for their end on demand; stores nothing.
 */
final class Traffic {

  /**
   * The range of the recording to search on either side of the moment, and the maximum number of
   * events.
   */
  private static final long WINDOW_NS = 2_000_000_000;

  private static final int MOST_EVENTS = 8_000;
  private static final int MOST_FLIGHTS = 300;

  /** The assumed flight time of datagrams without an end so far. */
  private static final long USUAL_NS = 200_000_000;

  private static final double LOST_AT = 0.75;

  private final Recording recording;
  private final SortedSet<String> channels = new TreeSet<>();
  private String channel = "";
  private boolean isOfSelectedOnly;

  Traffic(Recording recording) {
    this.recording = recording;
  }

  /** All that messages were seen on so far. */
  SortedSet<String> channels() {
    return channels;
  }

  /** Only those of one channel; of all if empty. */
  void only(String wanted) {
    channel = wanted;
  }

  String channel() {
    return channel;
  }

  /** Only those from and to the selected robot, where one is. */
  void onlyOfSelected(boolean isOn) {
    isOfSelectedOnly = isOn;
  }

  boolean isOfSelectedOnly() {
    return isOfSelectedOnly;
  }

  private record Key(RobotId from, long seq) {}

  private static final class Open {
    private final Sent sent;
    private boolean isAnswered;

    Open(Sent sent) {
      this.sent = sent;
    }
  }

  /**
   * The datagrams in flight.
   *
   * @param index number of events up to the moment
   * @param lingerNs how long an arrived datagram is still shown
   */
  List<Flight> at(long nowNs, int index, long lingerNs, @Nullable RobotId selected) {
    int from = Math.max(index - MOST_EVENTS, recording.firstAfter(nowNs - WINDOW_NS));
    int to = Math.min(index + MOST_EVENTS, recording.size());
    Map<Key, Open> sent = new LinkedHashMap<>();
    List<Flight> flights = new ArrayList<>();
    for (int i = from; i < to && flights.size() < MOST_FLIGHTS; i++) {
      TraceEvent event = recording.event(i);
      if (event.timeNs() > nowNs + WINDOW_NS) {
        break;
      }
      if (event instanceof Sent out && i < index) {
        channels.add(out.channel());
        sent.put(new Key(out.robot(), out.seq()), new Open(out));
      } else if (event instanceof Delivered in) {
        Open open = sent.get(new Key(in.from(), in.seq()));
        if (open != null) {
          open.isAnswered = true;
          add(flights, open.sent, in.robot(), in.timeNs(), true, nowNs, lingerNs, selected);
        }
      } else if (event instanceof Dropped lost) {
        Open open = oldest(sent, lost);
        if (open != null) {
          open.isAnswered = true;
          add(flights, open.sent, lost.robot(), lost.timeNs(), false, nowNs, lingerNs, selected);
        }
      }
    }
    if (to == recording.size() && !recording.isOver()) {
      addOpen(flights, sent, nowNs, selected);
    }
    return flights;
  }

  /** A drop does not identify its datagram; the oldest candidate is used. */
  private static @Nullable Open oldest(Map<Key, Open> sent, Dropped lost) {
    for (Open open : sent.values()) {
      if (open.sent.robot().name().equals(lost.from())
          && (open.sent.to().equals("*")
              || (!open.isAnswered && open.sent.to().equals(lost.robot().name())))) {
        return open;
      }
    }
    return null;
  }

  private void add(
      List<Flight> flights,
      Sent sent,
      RobotId to,
      long endNs,
      boolean isGood,
      long nowNs,
      long lingerNs,
      @Nullable RobotId selected) {
    if (endNs + lingerNs < nowNs || !isWanted(sent, to, selected)) {
      return;
    }
    double most = isGood ? 1 : LOST_AT;
    double share = endNs <= nowNs ? 1 : (nowNs - sent.timeNs()) / (double) (endNs - sent.timeNs());
    Flight.State state =
        endNs > nowNs
            ? Flight.State.UNDER_WAY
            : isGood ? Flight.State.DELIVERED : Flight.State.DROPPED;
    flights.add(
        new Flight(
            sent.robot(), to, sent.channel(), sent.message(), sent.timeNs(), share * most, state));
  }

  /** Datagrams whose end a live run has not reached yet. */
  private void addOpen(
      List<Flight> flights, Map<Key, Open> sent, long nowNs, @Nullable RobotId selected) {
    for (Open open : sent.values()) {
      Sent out = open.sent;
      if (flights.size() >= MOST_FLIGHTS) {
        return;
      }
      boolean isYoung = nowNs - out.timeNs() < USUAL_NS;
      if (!open.isAnswered && isYoung && RobotId.isValid(out.to())) {
        RobotId to = new RobotId(out.to());
        if (isWanted(out, to, selected)) {
          double share = (nowNs - out.timeNs()) / (double) USUAL_NS;
          flights.add(
              new Flight(
                  out.robot(),
                  to,
                  out.channel(),
                  out.message(),
                  out.timeNs(),
                  share,
                  Flight.State.UNDER_WAY));
        }
      }
    }
  }

  private boolean isWanted(Sent sent, RobotId to, @Nullable RobotId selected) {
    boolean isOnChannel = channel.isEmpty() || channel.equals(sent.channel());
    boolean isOfRobot =
        !isOfSelectedOnly
            || selected == null
            || selected.equals(to)
            || selected.equals(sent.robot());
    return isOnChannel && isOfRobot;
  }
}
