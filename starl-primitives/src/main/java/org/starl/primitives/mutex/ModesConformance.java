package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.ModesAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Replay;

/**
 * Every run of every mutex is a run of the theory {@code Modes_decls}, of sets and sequences, with and
 * without modes. A robot's place in a section with a capacity is the lowest one that is free.
 */
public final class ModesConformance extends GrantConformance<States, ModesAction> {

  public ModesConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public ModesConformance(AutomatonListener<States, ModesAction> steps) {
    super(
        ModesAutomaton.MODES_DECLS,
        "every mutex with modes",
        new Modes(),
        source ->
            new Replay<>(
                new ModesAutomaton(Sections::exclude, ModesConformance::most), source, steps));
  }

  @Override
  boolean begins(MutexFact.DoMutex request) {
    return true;
  }

  @Override
  boolean ends(MutexFact.DoMutex request) {
    return false;
  }

  /** The theory's limit, in which 0 is none. */
  private static long most(String section) {
    int capacity = Sections.capacity(section);
    return capacity == Integer.MAX_VALUE ? 0 : capacity;
  }

  private static final class Modes implements Theory<States, ModesAction> {
    @Override
    public ModesAction ask(RobotId i, List<String> sections, long ticket) {
      return new ModesAction.do_mutex(i, Sections.copyOf(sections));
    }

    @Override
    public ModesAction grant(RobotId i, String section, States state) {
      Set<RobotId> robots = new TreeSet<>(state.crit_set().arguments());
      robots.addAll(state.rest_set().arguments());
      robots.remove(i);
      Set<Long> taken = new TreeSet<>();
      for (RobotId j : robots) {
        if (state.held(j).contains(section)) {
          taken.add(state.place().at(j).at(section));
        }
      }
      long place = 0;
      while (taken.contains(place)) {
        place++;
      }
      return new ModesAction.grant(i, section, most(section) == 0 ? 0 : place);
    }

    @Override
    public ModesAction release(RobotId i, SortedSet<String> given) {
      return new ModesAction.release(i, given);
    }

    @Override
    public ModesAction withdraw(RobotId i) {
      return new ModesAction.withdraw(i);
    }

    @Override
    public ModesAction restart(RobotId i) {
      return new ModesAction.restart(i);
    }

    @Override
    public ModesAction standsIn(RobotId i, SortedSet<String> sections) {
      return new ModesAction.stands_in(i, sections);
    }

    @Override
    public SortedSet<String> crit(RobotId i, States state) {
      return state.crit_set().at(i);
    }

    @Override
    public SortedSet<String> rest(RobotId i, States state) {
      return state.rest_set().at(i);
    }

    @Override
    public Collection<String> asked(RobotId i, States state) {
      return state.req_set().at(i);
    }
  }
}
