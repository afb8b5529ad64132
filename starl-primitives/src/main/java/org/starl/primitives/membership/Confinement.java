package org.starl.primitives.membership;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * A change of the view that gives up {@code who}: it holds at most {@code sections}, now and later. The
 * next view lists it as a ghost fenced in these sections, or removes it if there are none.
 *
 * <p>Each fencer has promised never to consent to {@code who} again. {@code who} needs that consent, so
 * one fencer is enough. A fencer counts only if it is free in the view before the change and in the one
 * after it: without a fencer in the view, {@code who} may do without its consent.
 *
 * @param fencers the participants that made the promise. Empty: the robot of {@code who} itself
 *     declares, after a restart of its program, that {@code who} is dead and its body in no other section
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

  /** Writes who (process), sections, number of fencers (u8) and the fencers (process). */
  public void write(WireWriter out) {
    out.process(who);
    Sections.write(sections, out);
    out.u8(fencers.size());
    for (ProcessId fencer : fencers) {
      out.process(fencer);
    }
  }

  /** Reads what {@link #write} wrote; fencers must be in ascending order. */
  public static Confinement read(WireReader in) {
    ProcessId who = in.process();
    SortedSet<String> sections = Sections.read(in);
    int count = in.u8();
    TreeSet<ProcessId> fencers = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      ProcessId fencer = in.process();
      boolean isNext = fencers.isEmpty() || fencers.last().compareTo(fencer) < 0;
      if (fencer.equals(who) || !isNext) {
        throw new WireFormatException("fencer " + fencer + " of " + who);
      }
      fencers.add(fencer);
    }
    return new Confinement(who, sections, fencers);
  }

  /** As arguments of a trace's action: who, sections, fencers. */
  public List<String> args() {
    List<String> names = new ArrayList<>();
    fencers.forEach(fencer -> names.add(fencer.toString()));
    return List.of(who.toString(), Sections.text(sections), String.join(" ", names));
  }

  /**
   * Reads {@link #args}.
   *
   * @throws IllegalArgumentException if {@code args} are malformed
   */
  public static Confinement parse(List<String> args) {
    if (args.size() != 3) {
      throw new IllegalArgumentException(args + ": expected who, sections and fencers");
    }
    TreeSet<ProcessId> fencers = new TreeSet<>();
    for (String fencer : Sections.split(args.get(2), ' ')) {
      fencers.add(ProcessId.parse(fencer));
    }
    return new Confinement(ProcessId.parse(args.get(0)), Sections.parse(args.get(1)), fencers);
  }
}
