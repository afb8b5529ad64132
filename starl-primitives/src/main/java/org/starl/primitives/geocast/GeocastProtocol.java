package org.starl.primitives.geocast;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Region;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * One robot's part in geocasts: pure, driven by messages and the clock. Times are in ns on this
 * robot's clock, and never decrease from call to call.
 */
class GeocastProtocol<T> {

  private static final int MIN_KEPT = 64;

  private final ProcessId me;
  private final int deploymentOthers;
  private final Participants deployment;
  private final GeocastSettings settings;
  private final GeocastPort<T> port;

  /** This robot's geocasts whose interval is not over, the oldest first. */
  private final List<Underway<T>> underway = new ArrayList<>();

  /** The delivered geocasts, each with the last time at which a copy could be delivered. */
  final Map<GeocastId, Long> delivered = new HashMap<>();

  private int forgetAtSize = MIN_KEPT;
  private long lastNumber;

  private static final class Underway<T> {
    private final GeocastMessage.Copy<T> copy;
    private final GeocastReceipt receipt;
    private long waitNs;
    private long resendNs;
    private int deploymentAcks;

    Underway(GeocastMessage.Copy<T> copy, GeocastReceipt receipt, long waitNs) {
      this.copy = copy;
      this.receipt = receipt;
      this.waitNs = waitNs;
      this.resendNs = copy.startNs() + waitNs;
    }

    long wakeAtNs() {
      return Math.min(resendNs, copy.deadlineNs());
    }

    @Override
    public String toString() {
      return copy + "" + receipt.acknowledgedBy() + deploymentAcks;
    }
  }

  GeocastProtocol(
      ProcessId me, Participants deployment, GeocastSettings settings, GeocastPort<T> port) {
    this.me = me;
    this.deployment = deployment;
    this.deploymentOthers = deployment.size() - (deployment.contains(me.robot()) ? 1 : 0);
    this.settings = settings;
    this.port = port;
  }

  /** The id of the next geocast. */
  GeocastId nextId() {
    return new GeocastId(me, lastNumber + 1);
  }

  GeocastReceipt do_geocast(T message, Region area, long dNs, long nowNs) {
    GeocastId id = nextId();
    long deadlineNs = Math.addExact(nowNs, dNs);
    var copy = new GeocastMessage.Copy<>(id, area, nowNs, deadlineNs, message);
    lastNumber++;
    var cast = new Underway<>(copy, new GeocastReceipt(id, deployment), settings.firstResendNs());
    underway.add(cast);
    port.broadcast(copy);
    return cast.receipt;
  }

  /** Whether there was a geocast, and all are complete: the paper's {@code Gcastflag}. */
  boolean isComplete() {
    return lastNumber > 0 && underway.isEmpty();
  }

  /** The state without the times of repetitions: robots with equal texts behave alike. */
  String state() {
    SortedMap<String, Long> known = new TreeMap<>();
    delivered.forEach((id, lastNs) -> known.put(id.toString(), lastNs));
    return underway + " " + known + lastNumber + " " + forgetAtSize;
  }

  /** When {@link #timer} is due; {@code Long.MAX_VALUE} for never. */
  long wakeAtNs() {
    long earliest = Long.MAX_VALUE;
    for (int i = 0; i < underway.size(); i++) {
      earliest = Math.min(earliest, underway.get(i).wakeAtNs());
    }
    return earliest;
  }

  void timer(long nowNs) {
    for (int i = 0; i < underway.size(); i++) {
      Underway<T> cast = underway.get(i);
      if (nowNs >= cast.copy.deadlineNs()) {
        cast.receipt.complete();
      } else if (nowNs >= cast.resendNs) {
        cast.waitNs = settings.nextResendNs(cast.waitNs);
        cast.resendNs = nowNs + cast.waitNs;
        port.broadcast(cast.copy);
      }
    }
    underway.removeIf(cast -> cast.receipt.isComplete());
  }

  void received(RobotId from, GeocastMessage<T> message, long nowNs) {
    switch (message) {
      case GeocastMessage.Copy<T> copy -> copy(from, copy, nowNs);
      case GeocastMessage.Ack<T> ack -> acknowledged(from, ack.id());
    }
  }

  private void copy(RobotId from, GeocastMessage.Copy<T> copy, long nowNs) {
    ProcessId origin = copy.id().origin();
    if (!origin.robot().equals(from)) {
      return;
    }
    // All messages of a robot share the name in their headers: thousands of ids are kept.
    GeocastId id = new GeocastId(new ProcessId(from, origin.inc()), copy.id().number());
    if (delivered.containsKey(id)) {
      port.acknowledge(from, new GeocastMessage.Ack<>(id));
      return;
    }
    // The origin's clock is ahead of this clock by at most the skew.
    long lastNs = copy.deadlineNs() - settings.clockSkewNs();
    if (nowNs > lastNs) {
      port.dismissed(id, Dismissal.LATE);
    } else if (nowNs < copy.startNs() - settings.clockSkewNs()) {
      port.dismissed(id, Dismissal.EARLY);
    } else if (!(port.surelyInsideMm(copy.area()) > 0)) {
      port.dismissed(id, Dismissal.OUTSIDE);
    } else {
      forgetFinished(nowNs);
      delivered.put(id, lastNs);
      port.deliver(id, copy.message());
      port.acknowledge(from, new GeocastMessage.Ack<>(id));
    }
  }

  private void acknowledged(RobotId from, GeocastId id) {
    for (int i = 0; i < underway.size(); i++) {
      Underway<T> cast = underway.get(i);
      if (cast.copy.id().equals(id) && cast.receipt.acknowledged(from)) {
        if (deployment.contains(from)) {
          cast.deploymentAcks++;
        }
        if (!settings.openMembership() && cast.deploymentAcks == deploymentOthers) {
          cast.receipt.complete();
          underway.remove(i);
        }
        return;
      }
    }
  }

  // Forgets geocasts whose interval is over, but only after the number of entries has doubled.
  void forgetFinished(long nowNs) {
    if (delivered.size() >= forgetAtSize) {
      delivered.values().removeIf(lastNs -> lastNs < nowNs);
      forgetAtSize = Math.max(MIN_KEPT, 2 * delivered.size());
    }
  }
}
