package org.starl.sim.explore;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.random.Rng;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.fault.Fault;

/** Draws schedules, each for itself, from the copies of the run without changes. */
final class DrawnSearch implements Search {

  /** Copies that a drawn schedule can choose from. */
  private static final int MOST_DRAWN_FROM = 100_000;

  /** Copies of a drawn schedule that make its order. */
  private static final int COPIES_OF_ORDER = 1000;

  private final Exploration exploration;
  private final Predicate<List<Long>> isOwn;
  private @Nullable Draws draws;
  private long number;

  DrawnSearch(Exploration exploration, Predicate<List<Long>> isOwn) {
    this.exploration = exploration;
    this.isOwn = isOwn;
  }

  @Override
  public List<Node> next(int most) {
    List<Node> next = new ArrayList<>();
    if (draws == null) {
      next.add(new Node(List.of(0L), List.of(), 0, 0, 0));
      number = 1;
      return next;
    }
    while (next.size() < most && number < exploration.mostSchedules()) {
      List<Long> place = List.of(number);
      if (isOwn.test(place)) {
        next.add(new Node(place, drawn(draws, number), 0, 0, 0));
      }
      number++;
    }
    return next;
  }

  private List<Fault> drawn(Draws from, long schedule) {
    Strategy strategy = exploration.strategy();
    Rng rng = new Rng(exploration.seed()).fork(strategy + "/" + schedule);
    return strategy == Strategy.PCT ? from.pct(exploration.depth(), rng) : from.random(rng);
  }

  @Override
  public int mostCopies(Node node) {
    return needsAgain(node) ? MOST_DRAWN_FROM : COPIES_OF_ORDER;
  }

  @Override
  public boolean needsAgain(Node node) {
    return node.place().get(0) == 0;
  }

  @Override
  public Explored explored(Node node, RunOutcome outcome, Order order) {
    boolean isFirst = needsAgain(node);
    if (isFirst) {
      draws = new Draws(exploration.bounds(), order);
    }
    Long hash = isFirst ? null : Long.valueOf(order.hash());
    return new Explored(node.place(), node.schedule(), outcome, hash, order.steps(), List.of());
  }

  @Override
  public void took(Explored explored) {
    // the next schedule does not depend on it
  }

  @Override
  public boolean isAll() {
    return false;
  }
}
