package org.starl.gvh;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * {@code gvh.trace}: records what this robot does, under the names of the paper and the PVS
 * theories.
 */
public final class Trace {

  private final RobotId robot;
  private final Clock clock;
  private final TraceSink sink;

  public Trace(RobotId robot, Clock clock, TraceSink sink) {
    this.robot = robot;
    this.clock = clock;
    this.sink = sink;
  }

  /** Whether events are recorded: ask before building costly arguments. */
  public boolean isOn() {
    return sink.isOn();
  }

  /**
   * Records an atomic action, such as {@code mutex/crossing do_mutex A C}.
   *
   * @param source {@code app}, or a primitive and its instance
   */
  public void action(String source, String name, Object... args) {
    if (sink.isOn()) {
      List<String> texts = new ArrayList<>(args.length);
      for (Object arg : args) {
        texts.add(String.valueOf(arg));
      }
      sink.record(new TraceEvent.Action(clock.nowNs(), robot, source, name, List.copyOf(texts)));
    }
  }

  /** Records a new value of a variable. */
  public void variable(String source, String name, Object value) {
    if (sink.isOn()) {
      sink.record(
          new TraceEvent.Variable(clock.nowNs(), robot, source, name, String.valueOf(value)));
    }
  }
}
