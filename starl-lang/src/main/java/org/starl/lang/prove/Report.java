package org.starl.lang.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.starl.lang.verdict.Verdict;

/** What came of the claims on an automaton. */
public record Report(String automaton, List<Claim> claims) {

  /** What came of all. */
  public Verdict verdict() {
    return claims.stream()
        .map(claim ->
            claim.isGood()
                ? Verdict.HOLDS
                : claim.verdict() == Claim.Verdict.FAILED ? Verdict.VIOLATED : Verdict.NOT_DECIDED)
        .reduce(Verdict.HOLDS, Verdict::and);
  }

  /** Whether all hold. */
  public boolean isProved() {
    return claims.stream().allMatch(Claim::isGood);
  }

  /** The claim on a subject. */
  public Optional<Claim> claim(String subject) {
    return claims.stream().filter(claim -> claim.subject().equals(subject)).findFirst();
  }

  /** The names of the actions that do not keep what is claimed. */
  public Set<String> actions() {
    return claims.stream().flatMap(claim -> claim.action().stream()).collect(Collectors.toSet());
  }

  /**
   * For a person: a line for each claim, and below it what shows it.
   *
   * @param file in which the automaton is
   */
  public List<String> lines(String file) {
    List<String> lines = new ArrayList<>();
    for (Claim claim : claims) {
      lines.add(automaton + ": " + claim.subject() + " " + claim.text());
      claim.pos().ifPresent(pos -> lines.add("  at " + file + ":" + pos));
      claim.lines().forEach(line -> lines.add("  " + line));
    }
    return lines;
  }
}
