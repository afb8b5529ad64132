package org.starl.primitives.membership;

import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;

/**
 * A change of the view that gives up {@code who}: it holds at most {@code sections}, now and later. The
 * next view lists it as a ghost fenced in these sections, or removes it if there are none.
 *
 * <p>Each fencer has promised never to consent to {@code who} again. {@code who} needs that consent, so
 * one fencer is enough. A fencer counts only if it is free in the view before the change and in the one
 * after it: without a fencer in the view, {@code who} may do without its consent.
 *
 * @param fencers the participants that made the promise. Empty: the robot of {@code who} itself
 *     declares that {@code who}, an older process of it, holds and will hold no other section
 */
public record Confinement(ProcessId who, SortedSet<String> sections, SortedSet<ProcessId> fencers) {

  public Confinement {
    sections = Sections.copyOf(sections);
    fencers = Collections.unmodifiableSortedSet(new TreeSet<>(fencers));
    if (fencers.contains(who)) {
      throw new IllegalArgumentException(who + " is its own fencer");
    }
  }

  /** Whether it changes {@code view}. */
  public boolean changes(View view) {
    View.Ghost ghost = view.ghost(who);
    return view.contains(who) || (ghost != null && !sections.containsAll(ghost.sections()));
  }

  /** Whether all fencers are free in {@code view}. */
  public boolean hasFencersIn(View view) {
    return view.admitted().keySet().containsAll(fencers);
  }

  /** Whether it counts if {@code robot} proposes it: without fencers, only that of its own robot does. */
  public boolean isSaidBy(RobotId robot) {
    return !fencers.isEmpty() || who.robot().equals(robot);
  }

  /** {@code view} with this change. */
  public View applyTo(View view) {
    return view.confined(who, sections);
  }

  /** The process, its sections, and the fencers in ascending order. */
  public static final RecordShape<Confinement> SHAPE =
      Shapes.of(
          Confinement.class,
          part("who", PROCESS, Confinement::who),
          part("sections", Sections.SHAPE, Confinement::sections),
          part("fencers", Shapes.set(PROCESS, 0xFF), Confinement::fencers),
          Confinement::new);
}
