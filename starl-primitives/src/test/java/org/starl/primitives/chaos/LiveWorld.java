package org.starl.primitives.chaos;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.starl.id.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/** Robots with one pure protocol each, over a foul network; the trace tells when it is foul. */
public final class LiveWorld<R extends LiveRobot> extends FoulNetwork {

  private static final String FOUL = "foul";

  public final List<R> robots = new ArrayList<>();
  private boolean isFoul;

  public LiveWorld(long seed, Monitor... specs) {
    super(seed, specs);
  }

  /** Adds robots {@code bot0}, {@code bot1}, ..., none of them started. */
  public void add(int count, Function<RobotId, R> maker) {
    for (int i = 0; i < count; i++) {
      robots.add(maker.apply(new RobotId("bot" + i)));
    }
  }

  /** What the network and the disks are like from now on; anything but fair is told as a fault. */
  public void weather(Weather newWeather) {
    weather = newWeather;
    tellFault();
  }

  /** Robots below this index and those at or above it cannot hear each other; 0 for no cut. */
  public void cutAt(int index) {
    cutAt = index;
    tellFault();
  }

  private void tellFault() {
    boolean nowFoul = cutAt > 0 || weather.loss() > 0 || weather.maxDelayMs() > 50;
    if (nowFoul != isFoul) {
      isFoul = nowFoul;
      String name = nowFoul ? TraceEvent.Fault.BEGIN : TraceEvent.Fault.END;
      record(new TraceEvent.Fault(nowNs(), TraceEvent.Fault.WORLD, name, FOUL));
    }
  }

  @Override
  protected int indexOf(RobotId name) {
    for (int i = 0; i < robots.size(); i++) {
      if (robots.get(i).name.equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException("no robot " + name);
  }

  R robot(RobotId name) {
    return robots.get(indexOf(name));
  }
}
