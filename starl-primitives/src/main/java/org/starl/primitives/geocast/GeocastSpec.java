package org.starl.primitives.geocast;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.RegionText;
import org.starl.id.RobotId;
import org.starl.primitives.geocast.CastRecord.Copy;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/**
 * What every geocast and broadcast of a run owes (paper, section 4.2): {@code exclusion}, {@code
 * deadline}, {@code once} and {@code inclusion}, as the package's contract has them, judged by the
 * true bodies. Exclusion and inclusion speak of the whole interval, so they are checked at its end;
 * of an interval that outlasts the run nothing is asked.
 *
 * <p>Inclusion is owed by robots that a copy has reached in time (or by all, if the origin never
 * sent one): whether copies arrive is the network's.
 */
public final class GeocastSpec implements Monitor {

  static final String EXCLUSION = "exclusion";
  static final String INCLUSION = "inclusion";
  static final String DEADLINE = "deadline";
  static final String ONCE = "once";

  private static final String EVERYONE = "*";

  private final double positionErrorMm;
  private final long clockSkewNs;
  private final Casts casts;

  /** What each robot's next datagram to everyone is a copy of. */
  private final Map<RobotId, CastRecord> announced = new TreeMap<>();

  /** For a world without clock skew, and with position errors below 50 mm. */
  public GeocastSpec() {
    this(50, 0);
  }

  /**
   * @param positionErrorMm inclusion is owed as long as robots know their places so well, and not to
   *     those nearer to the border than twice this: their believed place, so far off, must still be
   *     inside for certain
   * @param clockSkewNs no two clocks differ by more
   */
  public GeocastSpec(double positionErrorMm, long clockSkewNs) {
    this.positionErrorMm = positionErrorMm;
    this.clockSkewNs = clockSkewNs;
    casts = new Casts(2 * positionErrorMm);
  }

  @Override
  public List<String> lemmas() {
    return List.of(EXCLUSION, INCLUSION, DEADLINE, ONCE);
  }

  @Override
  public String says(String lemma) {
    return switch (lemma) {
      case EXCLUSION -> "A robot that is outside the area throughout does not get the message.";
      case INCLUSION ->
          "A robot that is in the area throughout, and that a copy reaches in time, gets the "
              + "message.";
      case DEADLINE -> "Nobody gets the message after its interval is over.";
      case ONCE -> "Nobody gets the message twice.";
      default -> "";
    };
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new GeocastConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    casts.observe(event, judging(report));
    switch (event) {
      case Action action when GeocastTrace.isGeocast(action.source()) -> acted(action, report);
      case Sent sent when GeocastTrace.isGeocast(sent.channel()) -> sent(sent);
      case Delivered delivered when GeocastTrace.isGeocast(delivered.channel()) ->
          reached(delivered);
      default -> {
        // Of no concern here.
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    casts.finish(endNs, judging(report));
  }

  private static Casts.Listener judging(Report report) {
    return new Casts.Listener() {
      @Override
      public void entered(CastRecord cast, RobotId robot) {
        // Looked at when the interval is over.
      }

      @Override
      public void over(CastRecord cast) {
        judge(cast, report);
      }
    };
  }

  private void acted(Action action, Report report) {
    CastRecord cast = casts.of(action);
    switch (action.name()) {
      case GeocastTrace.DELIVER -> delivered(action, cast, report);
      case GeocastTrace.COPY -> {
        if (cast == null) {
          announced.remove(action.robot());
        } else {
          announced.put(action.robot(), cast);
        }
      }
      case GeocastTrace.DISMISS -> {
        if (cast != null && isBeyondAssumptions(action.args())) {
          cast.excuse(action.robot());
        }
      }
      default -> {
        // Of no concern here.
      }
    }
  }

  private void delivered(Action action, @Nullable CastRecord cast, Report report) {
    RobotId robot = action.robot();
    report.checked(DEADLINE);
    if (cast == null) {
      String detail = "delivers " + action.args().get(0) + ", whose interval is over";
      report.violated(DEADLINE, action.timeNs(), List.of(robot), detail);
      return;
    }
    report.checked(ONCE);
    if (!cast.holders.add(robot)) {
      String detail = "delivers " + cast.id + " again";
      report.violated(ONCE, action.timeNs(), List.of(robot), detail);
    }
    cast.deliveredNs.putIfAbsent(robot, action.timeNs());
  }

  private void sent(Sent sent) {
    CastRecord cast = announced.get(sent.robot());
    if (cast != null && sent.to().equals(EVERYONE) && sent.channel().equals(cast.source)) {
      announced.remove(sent.robot());
      cast.copies.add(new Copy(sent.robot(), sent.seq()));
    }
  }

  private void reached(Delivered delivered) {
    Copy copy = new Copy(delivered.from(), delivered.seq());
    for (CastRecord cast : casts.active()) {
      boolean inTime = delivered.timeNs() <= cast.deadlineNs - 2 * clockSkewNs;
      if (inTime && cast.source.equals(delivered.channel()) && cast.isCopy(copy)) {
        cast.reached.add(delivered.robot());
      }
    }
  }

  private static void judge(CastRecord cast, Report report) {
    cast.deliveredNs.keySet().forEach(robot -> report.checked(EXCLUSION));
    for (RobotId robot : cast.intruders()) {
      String detail = "delivered " + cast.id + ", was outside " + RegionText.format(cast.area);
      report.violated(EXCLUSION, cast.deliveredAtNs(robot), List.of(robot), detail);
    }
    for (RobotId robot : cast.debtors()) {
      report.checked(INCLUSION);
      if (!cast.deliveredNs.containsKey(robot)) {
        String detail = "never delivered " + cast.id + ", was in " + RegionText.format(cast.area);
        report.violated(INCLUSION, cast.deadlineNs, List.of(robot), detail);
      }
    }
  }

  private boolean isBeyondAssumptions(List<String> dismissal) {
    return dismissal.get(1).equals(GeocastTrace.EARLY)
        || Double.parseDouble(dismissal.get(2)) > positionErrorMm;
  }
}
