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
import org.starl.sim.record.MessageText;
import org.starl.sim.replay.Recording;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;

/**
 * Finds the messages in transit at a moment of a recording: searches back for sent messages, and
 * ahead for their delivery or loss. Keeps no state between queries except the list of channels.
 */
public final class Traffic {

  /** Limits of the search before and after the moment. */
  private static final long WINDOW_NS = 2 * Time.NS_PER_S;

  private static final int MOST_EVENTS = 8_000;
  private static final int MOST_FLIGHTS = 300;

  /** Assumed transit time of messages whose end is not recorded yet. */
  private static final long USUAL_NS = 200 * Time.NS_PER_MS;

  private static final double LOST_AT = 0.75;

  private final Recording recording;
  private final SortedSet<String> channels = new TreeSet<>();
  private String channel = "";
  private boolean isOfSelectedOnly;

  /** Finds messages of {@code recording}, on all channels. */
  public Traffic(Recording recording) {
    this.recording = recording;
  }

  /** The channels of all messages found so far. */
  SortedSet<String> channels() {
    return channels;
  }

  /** Shows only messages of one channel; of all if empty. */
  void only(String wanted) {
    channel = wanted;
  }

  String channel() {
    return channel;
  }

  /** Sets whether to show only messages from and to the selected robot, if there is one. */
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
   * The messages in transit at {@code nowNs}.
   *
   * @param index number of events up to {@code nowNs}
   * @param lingerNs simulated time for which an arrived message stays visible
   */
  public List<Flight> at(long nowNs, int index, long lingerNs, @Nullable RobotId selected) {
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
        channels.add(out.channel().name());
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

  /** A drop event does not identify the datagram: this is the oldest candidate. */
  private static @Nullable Open oldest(Map<Key, Open> sent, Dropped lost) {
    for (Open open : sent.values()) {
      if (open.sent.robot().name().equals(lost.from())
          && (open.sent.to().equals(Sent.ALL)
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
    if (endNs > nowNs) {
      double most = isGood ? 1 : LOST_AT;
      double share = (nowNs - sent.timeNs()) / (double) (endNs - sent.timeNs());
      flights.add(flight(sent, to, share * most, Flight.State.IN_TRANSIT));
    } else {
      Flight.State state = isGood ? Flight.State.DELIVERED : Flight.State.DROPPED;
      flights.add(flight(sent, to, isGood ? 1 : LOST_AT, state));
    }
  }

  private static Flight flight(Sent sent, RobotId to, double share, Flight.State state) {
    String title = MessageText.name(sent.shape(), sent.message());
    return new Flight(sent.robot(), to, sent.channel(), title, share, state);
  }

  /** Adds messages whose delivery or loss is not recorded yet. */
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
          flights.add(flight(out, to, share, Flight.State.IN_TRANSIT));
        }
      }
    }
  }

  private boolean isWanted(Sent sent, RobotId to, @Nullable RobotId selected) {
    boolean isOnChannel = channel.isEmpty() || channel.equals(sent.channel().name());
    boolean isOfRobot =
        !isOfSelectedOnly
            || selected == null
            || selected.equals(to)
            || selected.equals(sent.robot());
    return isOnChannel && isOfRobot;
  }
}
