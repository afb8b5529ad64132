package org.starl.primitives;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.starl.trace.TraceEvent;

/**
 * The phases of one primitive on a robot, as far as the trace shows them, and its messages. So a
 * campaign can count which messages arrived in which phase.
 *
 * @param primitive its name in sources: {@code mutex}
 * @param names all phases; a robot's program begins with the first
 * @param channels the sealed type of the messages of each of its channels, by the channel's name
 *     without the instance: {@code election}, {@code election.synod}
 * @param steps makes a step for an instance in a program, from its first event on
 */
public record Phases(
    String primitive,
    List<String> names,
    SortedMap<String, Class<?>> channels,
    Supplier<Step> steps) {

  /** How the events of one instance in one robot's program change its phase. */
  @FunctionalInterface
  public interface Step {

    /**
     * The phase after an action of the instance, or after a change of one of its variables. To be
     * called for each of them, in their order.
     *
     * @param before the phase before
     */
    String after(String before, TraceEvent event);
  }

  public Phases {
    names = List.copyOf(names);
    channels = Collections.unmodifiableSortedMap(new TreeMap<>(channels));
  }

  /** A primitive with one channel, of its own name, for messages of this sealed type. */
  public static Phases of(
      String primitive, Class<?> messages, Supplier<Step> steps, Object... names) {
    List<String> texts = new ArrayList<>();
    for (Object name : names) {
      texts.add(name.toString());
    }
    return new Phases(primitive, texts, new TreeMap<>(), steps).with(primitive, messages);
  }

  /** With a further channel. */
  public Phases with(String channel, Class<?> messages) {
    SortedMap<String, Class<?>> all = new TreeMap<>(channels);
    all.put(channel, messages);
    return new Phases(primitive, names, all, steps);
  }

  /** The phase at the start of a robot's program. */
  public String first() {
    return names.get(0);
  }
}
