package org.starl.gvh;

import java.util.ArrayList;
import java.util.List;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.shape.RecordShape;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;
import org.starl.trace.Var;

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

  /** Records a fact of the app. */
  public <F> void action(RecordShape<F> shape, F fact) {
    action(Instance.APP, shape, fact);
  }

  /** Records a fact of a primitive, or of a part of the app: an atomic action. */
  public <F> void action(Instance source, RecordShape<F> shape, F fact) {
    if (sink.isOn()) {
      sink.record(TraceEvent.Action.of(clock.nowNs(), robot, source, shape, fact));
    }
  }

  /** Records a fact that is one of the records of a sum. */
  public <F> void action(Instance source, SumShape<F> shape, F fact) {
    if (sink.isOn()) {
      sink.record(TraceEvent.Action.of(clock.nowNs(), robot, source, shape, fact));
    }
  }

  /**
   * Records an action in words, for people who read the trace: {@code action("app", "paint", name)}.
   * What a monitor reads is a fact with a shape.
   *
   * @param source {@code app}, or another name for a part of the app
   * @throws IllegalArgumentException if the source is an instance of a primitive, whose facts have
   *     shapes: its monitors would not see the words
   */
  public void action(String source, String name, Object... words) {
    if (source.indexOf('/') >= 0) {
      throw new IllegalArgumentException(
          "words of '" + source + "': expected app or a part of it; a primitive has facts");
    }
    if (sink.isOn()) {
      List<String> texts = new ArrayList<>(words.length);
      for (Object word : words) {
        texts.add(String.valueOf(word));
      }
      action(Instance.of(source), Note.SHAPE, new Note(name, texts));
    }
  }

  /** Records a new value of a variable. */
  <T> void variable(Instance source, Var<T> variable, T value) {
    if (sink.isOn()) {
      sink.record(new TraceEvent.Variable(clock.nowNs(), robot, source, variable, value));
    }
  }
}
