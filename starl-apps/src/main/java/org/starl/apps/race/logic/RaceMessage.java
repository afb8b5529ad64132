package org.starl.apps.race.logic;

import static org.starl.shape.Shapes.part;

import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;

/** A message between the robots of a race. */
sealed interface RaceMessage permits Claim, RaceMessage.Question {

  /** No race has more points. */
  int MOST = 1 << Character.SIZE;

  /** From a robot that has (re)started and knows no winners: which points are won? */
  record Question() implements RaceMessage {}

  /**
   * The shape of messages.
   *
   * @param points of the race: claims on other points are refused
   */
  static SumShape<RaceMessage> shape(int points) {
    Shape<Integer> point =
        Shapes.U16.where(number -> {
          if (number >= points) {
            throw new IllegalArgumentException("point " + number + " of a race of " + points);
          }
        });
    return Shapes.oneOf(
        RaceMessage.class,
        Shapes.of(
            Claim.class,
            part("point", point, Claim::point),
            part("winner", Shapes.ROBOT, Claim::winner),
            part("atNs", Shapes.LONG, Claim::atNs),
            part("keptOffMm", Shapes.INT, Claim::keptOffMm),
            Claim::new),
        Shapes.of(Question.class, Question::new));
  }
}
