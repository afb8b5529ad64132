package org.starl.primitives.membership;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * A numbered list of participants. For one instance, equal numbers mean equal lists (agreement), and
 * a list contains every participant admitted before that has neither left nor been confined
 * (inclusion).
 *
 * @param number from 1; 0 is {@link #NONE}, before any view
 * @param admitted the participants that are free to act, each with the number of the view that
 *     admitted it
 * @param ghosts the participants that were given up as crashed and may still hold something
 */
public record View(
    long number, SortedMap<ProcessId, Long> admitted, SortedMap<ProcessId, Ghost> ghosts) {

  public static final View NONE = new View(0, new TreeMap<>());

  /** The shape of sets of participants. */
  public static final Shape<SortedSet<ProcessId>> PROCESSES = Shapes.set(PROCESS, 0xFFFF);

  /**
   * A fenced participant: it holds at most {@code sections}, now and later.
   *
   * @param admittedBy the number of the view that admitted it
   * @param sections at least one
   */
  public record Ghost(long admittedBy, SortedSet<String> sections) {

    public Ghost {
      sections = Sections.copyOf(sections);
      if (sections.isEmpty()) {
        throw new IllegalArgumentException("a ghost without sections: expected none");
      }
    }

    static final Shape<Ghost> SHAPE =
        Shapes.of(
            Ghost.class,
            part("admittedBy", LONG, Ghost::admittedBy),
            part("sections", Sections.SHAPE, Ghost::sections),
            Ghost::new);
  }

  /** The shape of {@link #admitted}. */
  public static final Shape<SortedMap<ProcessId, Long>> ADMITTED =
      Shapes.map(PROCESS, LONG, 0xFFFF);

  /** The shape of {@link #ghosts}. */
  public static final Shape<SortedMap<ProcessId, Ghost>> GHOSTS =
      Shapes.map(PROCESS, Ghost.SHAPE, 0xFFFF);

  /** The shape of views. */
  public static final Shape<View> SHAPE =
      Shapes.of(
          View.class,
          part("number", LONG, View::number),
          part("admitted", ADMITTED, View::admitted),
          part("ghosts", GHOSTS, View::ghosts),
          View::new);

  public View {
    if (number < 0) {
      throw new IllegalArgumentException("view number " + number + ": expected 0 or above");
    }
    admitted = Collections.unmodifiableSortedMap(new TreeMap<>(admitted));
    ghosts = Collections.unmodifiableSortedMap(new TreeMap<>(ghosts));
    for (Map.Entry<ProcessId, Long> entry : admitted.entrySet()) {
      requireBefore(number, entry.getKey(), entry.getValue());
    }
    for (Map.Entry<ProcessId, Ghost> entry : ghosts.entrySet()) {
      requireBefore(number, entry.getKey(), entry.getValue().admittedBy());
      if (admitted.containsKey(entry.getKey())) {
        throw new IllegalArgumentException(
            "view " + number + " lists " + entry.getKey() + " twice");
      }
    }
  }

  /** A view without ghosts. */
  public View(long number, SortedMap<ProcessId, Long> admitted) {
    this(number, admitted, new TreeMap<>());
  }

  /** View 1 of a closed group: it admits all {@code ids}. */
  public static View closed(Collection<ProcessId> ids) {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (ProcessId id : ids) {
      admitted.put(id, 1L);
    }
    return new View(1, admitted);
  }

  /** View 1 of the closed group of the robots' first starts. */
  public static View closed(Participants robots) {
    List<ProcessId> ids = new ArrayList<>();
    for (RobotId robot : robots) {
      ids.add(ProcessId.first(robot, 1));
    }
    return closed(ids);
  }

  /** Whether {@code id} is free to act. */
  public boolean contains(ProcessId id) {
    return admitted.containsKey(id);
  }

  /** Whether {@code id} is free or a ghost. */
  public boolean mentions(ProcessId id) {
    return admitted.containsKey(id) || ghosts.containsKey(id);
  }

  public @Nullable Ghost ghost(ProcessId id) {
    return ghosts.get(id);
  }

  /** The number of the view that admitted {@code id}, which must be free. */
  public long admittedBy(ProcessId id) {
    Long by = admitted.get(id);
    if (by == null) {
      throw new IllegalArgumentException(id + " is not in view " + number);
    }
    return by;
  }

  /** The free ids, in order. */
  public List<ProcessId> ids() {
    return List.copyOf(admitted.keySet());
  }

  /** The free ids and the ghosts, in order. */
  public SortedSet<ProcessId> mentioned() {
    SortedSet<ProcessId> all = new TreeSet<>(admitted.keySet());
    all.addAll(ghosts.keySet());
    return all;
  }

  /** The robots of the free ids. */
  public Participants participants() {
    List<RobotId> robots = new ArrayList<>();
    for (ProcessId id : admitted.keySet()) {
      robots.add(id.robot());
    }
    return Participants.of(robots);
  }

  // Changes.

  /** The same with the next number. */
  public View next() {
    return new View(number + 1, admitted, ghosts);
  }

  /** With {@code id}, admitted by this view, unless this view mentions it. */
  public View with(ProcessId id) {
    if (mentions(id)) {
      return this;
    }
    SortedMap<ProcessId, Long> free = new TreeMap<>(admitted);
    free.put(id, number);
    return new View(number, free, ghosts);
  }

  /** Without {@code id}. */
  public View without(ProcessId id) {
    SortedMap<ProcessId, Long> free = new TreeMap<>(admitted);
    SortedMap<ProcessId, Ghost> others = new TreeMap<>(ghosts);
    free.remove(id);
    others.remove(id);
    return new View(number, free, others);
  }

  /**
   * With {@code id} as a ghost of {@code sections}, if this view mentions it. A ghost keeps only the
   * sections that it had before. A ghost without sections is removed.
   */
  public View confined(ProcessId id, SortedSet<String> sections) {
    if (!mentions(id)) {
      return this;
    }
    Ghost before = ghosts.get(id);
    SortedSet<String> left =
        before == null ? sections : Sections.common(before.sections(), sections);
    View rest = without(id);
    if (left.isEmpty()) {
      return rest;
    }
    SortedMap<ProcessId, Ghost> others = new TreeMap<>(rest.ghosts());
    others.put(id, new Ghost(before == null ? admittedBy(id) : before.admittedBy(), left));
    return new View(number, rest.admitted(), others);
  }

  // Text.

  /**
   * {@code 3:bot0@1,bot2@3|bot1@2[A B]}: number; the free ids, each
   * {@code @} the view that admitted it; and, if there are ghosts, a bar and the ghosts, each with its
   * sections.
   */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(number).append(':');
    String separator = "";
    for (Map.Entry<ProcessId, Long> entry : admitted.entrySet()) {
      text.append(separator).append(entry.getKey()).append('@').append(entry.getValue());
      separator = ",";
    }
    separator = "|";
    for (Map.Entry<ProcessId, Ghost> entry : ghosts.entrySet()) {
      Ghost ghost = entry.getValue();
      text.append(separator).append(entry.getKey()).append('@').append(ghost.admittedBy());
      text.append('[').append(Sections.text(ghost.sections())).append(']');
      separator = ",";
    }
    return text.toString();
  }

  private static void requireBefore(long number, ProcessId id, long by) {
    if (by > number || by < 1) {
      throw new IllegalArgumentException("view " + number + " lists " + id + " admitted by " + by);
    }
  }
}
