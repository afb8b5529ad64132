package org.starl.apps.race.logic;

/** What robots in a race tell each other. */
sealed interface RaceMessage permits Claim, RaceMessage.Question {

  /** From a robot whose program has started anew and knows nothing: what is taken? */
  record Question() implements RaceMessage {}
}
