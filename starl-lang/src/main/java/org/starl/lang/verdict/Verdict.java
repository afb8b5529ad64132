package org.starl.lang.verdict;

/** What came of a question, from best to worst. */
public enum Verdict {
  /** It holds for all that was asked about, and nothing was left out. */
  HOLDS,
  /** Part of it was not looked at, or could not be decided. */
  NOT_DECIDED,
  /** A state or step was found that breaks it. */
  VIOLATED;

  /** The worse of the two. */
  public Verdict and(Verdict other) {
    return compareTo(other) >= 0 ? this : other;
  }
}
