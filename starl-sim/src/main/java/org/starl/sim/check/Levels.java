package org.starl.sim.check;

import java.util.ArrayList;
import java.util.List;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * Notes when a run reaches each level of a {@link Splitting}. A level is an event of the trace, named
 * {@code mutex.withdraw} (an action of a primitive or of {@code app}), {@code fault.restart}, or
 * {@code mutex.Fence} (the delivery of a message). The run has reached as many levels as events of the
 * list have happened, in any order; a name that is listed twice must happen twice.
 */
public final class Levels implements SimObserver {

  private final List<String> left;
  private final List<Long> atNs = new ArrayList<>();

  /** @throws BadInput if a name has not the form {@code source.name} */
  public Levels(List<String> names) {
    for (String name : names) {
      if (!name.matches("[^.\\s]+\\.[^.\\s]+")) {
        throw new BadInput(
            BadInput.quote(name) + ": expected SOURCE.NAME of an event, such as fault.restart");
      }
    }
    left = new ArrayList<>(names);
  }

  @Override
  public void observed(TraceEvent event) {
    switch (event) {
      case TraceEvent.Action action -> happened(action.source().name(), action.name(), event);
      case TraceEvent.Fault fault -> happened("fault", fault.name(), event);
      case TraceEvent.Delivered delivered ->
          happened(delivered.channel().name(), type(delivered.message()), event);
      default -> {}
    }
  }

  /** The name of a record's class; a message that is only a text is its own name. */
  private static String type(Object message) {
    return message instanceof Record ? message.getClass().getSimpleName() : message.toString();
  }

  private void happened(String source, String name, TraceEvent event) {
    for (int i = 0; i < left.size(); i++) {
      String wanted = left.get(i);
      int dot = wanted.indexOf('.');
      if (wanted.endsWith(name)
          && wanted.length() == dot + 1 + name.length()
          && isOf(source, wanted, dot)) {
        left.remove(i);
        atNs.add(event.timeNs());
        return;
      }
    }
  }

  /** Whether the source is {@code mutex} or one of its instances or parts, if that is wanted. */
  private static boolean isOf(String source, String wanted, int length) {
    boolean isLonger = source.length() > length;
    return source.regionMatches(0, wanted, 0, length)
        && (isLonger
            ? source.charAt(length) == '/' || source.charAt(length) == '.'
            : source.length() == length);
  }

  /** A run that is bad already reaches no more: all its copies would be bad. */
  @Override
  public void violated(SpecReport.Violation violation) {
    left.clear();
  }

  /** When each level was reached, in ns of virtual time. */
  public List<Long> atNs() {
    return List.copyOf(atNs);
  }
}
