package org.starl.lang.prove;

import com.microsoft.z3.Context;
import com.microsoft.z3.Native;
import com.microsoft.z3.Z3Exception;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/** A session of Z3 with one script. It reads texts alone, so that a kept script gives the same outside of StarL. */
final class Solver implements AutoCloseable {

  /** What Z3 finds of a script. */
  enum Answer {
    /** No values satisfy it: the obligation holds. */
    UNSAT,
    /** Some values do. */
    SAT,
    /** Z3 has not decided it within the limit. */
    UNKNOWN
  }

  private static final long LEAST_MS = 10_000;
  private static final long STEPS_PER_MS = 100;

  private final long limit;
  private final Script script;
  private final List<String> preferred = new ArrayList<>();
  private Context context;
  private boolean isSpent;
  private boolean hasModel = true;

  /**
   * @param limit steps of Z3 for each check
   * @throws NoSolver if Z3 cannot be loaded
   */
  Solver(Script script, long limit) {
    this.script = script;
    this.limit = limit;
    context = open();
    begin();
  }

  private void begin() {
    eval(options(limit));
    eval(script.toString());
  }

  /** The lines before a script. The time is for what Z3 does not count: a usual machine needs a tenth of it. */
  static String options(long limit) {
    return "(set-option :rlimit "
        + limit
        + ")\n(set-option :timeout "
        + (LEAST_MS + limit / STEPS_PER_MS)
        + ")\n(set-option :smt.random_seed 1)\n";
  }

  private static Context open() {
    try {
      return new Context();
    } catch (LinkageError e) {
      throw new NoSolver(e.getCause() == null ? e : e.getCause());
    }
  }

  private String eval(String text) {
    String answer = Native.evalSmtlib2String(context.nCtx(), text);
    if (answer.contains("(error")) {
      throw new IllegalStateException(answer.strip());
    }
    return answer.strip();
  }

  Answer check() {
    return switch (eval("(check-sat)")) {
      case "sat" -> isModel() ? Answer.SAT : Answer.UNKNOWN;
      case "unsat" -> Answer.UNSAT;
      default -> {
        requireUninterrupted();
        yield Answer.UNKNOWN;
      }
    };
  }

  /** While Z3 searches, it takes the signal of Ctrl-C from this process, and ends the search. */
  private void requireUninterrupted() {
    if (eval("(get-info :reason-unknown)").contains("interrupted")) {
      throw new Interrupted();
    }
  }

  /**
   * Z3 also answers "sat" with values that do not satisfy the script: 4.14 has errors in arrays. Quantified
   * conditions are not asked, as that may need more steps than the answer did.
   */
  private boolean isModel() {
    return script.conditions().stream()
        .filter(each -> !Smt.isQuantified(each))
        .noneMatch(each -> value(each).word().equals("false"));
  }

  /** Keeps {@code condition} if the rest can be satisfied with it; after that there is a model. */
  void prefer(String condition) {
    if (isSpent) {
      return;
    }
    try {
      eval("(push)\n(assert " + condition + ")");
      if (check() == Answer.SAT) {
        preferred.add(condition);
        return;
      }
      eval("(pop)");
      isSpent = check() != Answer.SAT;
    } catch (Z3Exception overLimit) {
      isSpent = true;
    }
    if (isSpent) {
      context.close();
      context = open();
      begin();
      preferred.forEach(each -> eval("(assert " + each + ")"));
      hasModel = check() == Answer.SAT;
    }
  }

  /** Whether there is a model to ask for values. */
  boolean hasModel() {
    return hasModel;
  }

  /** The value of a term in the model of the last check. */
  SExpr value(String term) {
    return SExpr.read(eval("(get-value (" + term + "))")).at(0).at(1);
  }

  boolean isTrue(String term) {
    return value(term).word().equals("true");
  }

  /** A number's value; fractions have a few digits. */
  String number(String term) {
    return decimal(value(term)).stripTrailingZeros().toPlainString();
  }

  private static BigDecimal decimal(SExpr value) {
    if (!value.word().isEmpty()) {
      return new BigDecimal(value.word());
    }
    BigDecimal first = decimal(value.at(1));
    return value.at(0).word().equals("-")
        ? first.negate()
        : first.divide(decimal(value.at(2)), MathContext.DECIMAL32);
  }

  @Override
  public void close() {
    context.close();
  }
}
