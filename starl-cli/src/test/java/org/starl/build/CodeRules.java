package org.starl.build;

import java.util.List;
import java.util.function.Predicate;

/** Calls and types that shipped code does without, each with what to use instead. */
final class CodeRules {

  private static final String CORE = "starl-core/src/main/java/org/starl/Sample.java";

  private CodeRules() {}

  static List<Rule> all() {
    return List.of(
        call(
            "wall clock",
            "gvh.plat.clock.nowNs(): time is the platform's, virtual in a simulation",
            CodeRules::isMain,
            "\\b(System\\s*(\\.|::)\\s*(currentTimeMillis|nanoTime)|(Instant|LocalDate|LocalTime"
                + "|LocalDateTime|ZonedDateTime)\\s*\\.\\s*now|Clock\\s*\\.\\s*system\\w*)\\b",
            "long t = System.nanoTime();"),
        call(
            "randomness without the run's seed",
            "org.starl.random.Rng, forked by a stable name",
            CodeRules::isMain,
            "\\bMath\\s*\\.\\s*random\\b|\\bnew\\s+(Secure|Splittable)?Random\\b"
                + "|\\bThreadLocalRandom\\b|\\brandomUUID\\b|\\bCollections\\s*\\.\\s*shuffle\\s*\\([^,()]*\\)"
                + "|\\bjava\\.util\\.random\\b",
            "double x = Math.random();"),
        call(
            "Math functions whose last bit is the machine's choice",
            "StrictMath, which is the same on every JDK",
            CodeRules::isMain,
            "(?<!Strict)\\bMath\\s*\\.\\s*(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|hypot|log"
                + "|log10|log1p|exp|expm1|pow|cbrt)\\b",
            "double x = Math.atan2(y, x);"),
        call(
            "a thread's sleep",
            "sleep(ms) of LogicThread in an app, a timer of gvh.plat.timers elsewhere; in a test,"
                + " virtual time or a latch",
            SourceFile::isCode,
            "\\bThread\\s*\\.\\s*sleep\\b|\\bTimeUnit\\s*\\.\\s*\\w+\\s*\\.\\s*sleep\\b",
            "Thread.sleep(100);"),
        call(
            "threads and locks where one strand runs at a time",
            "nothing: what lies between two waits of a strand is atomic",
            CodeRules::isOnStrand,
            "\\bsynchronized\\b|\\bvolatile\\b|\\bjava\\.util\\.concurrent\\b|\\bnew\\s+Thread\\b"
                + "|\\bThreadLocal\\b|\\bThread\\s*\\.\\s*(of|start)\\w+|\\.parallel(Stream)?\\s*\\(",
            "private volatile boolean done;"),
        call(
            "threads and locks in the simulator and its tools",
            "events of org.starl.sim.kernel; whole runs side by side are the campaign's business",
            file -> isMain(file) && !isOnStrand(file) && !file.path().startsWith("starl-android/"),
            "\\bsynchronized\\b|\\bvolatile\\b|\\bjava\\.util\\.concurrent\\.(?!Callable)"
                + "|\\bnew\\s+Thread\\b|\\bThreadLocal\\b|\\bThread\\s*\\.\\s*(of|start)\\w+"
                + "|\\.parallel(Stream)?\\s*\\(",
            "starl-sim/src/main/java/org/starl/sim/Sample.java",
            "Thread.ofVirtual().start(work);"),
        call(
            "a collection in hash order",
            "TreeMap, TreeSet, LinkedHashMap, LinkedHashSet: their order is the same in every run",
            CodeRules::decides,
            "\\bnew\\s+(Weak|Identity)?Hash(Map|Set)\\b|\\bCollectors\\s*\\.\\s*(groupingBy|toSet"
                + "|toMap)\\s*\\([^,()]*\\)",
            "Set<RobotId> seen = new HashSet<>();"),
        call(
            "identity hash",
            "a number or a name of its own",
            SourceFile::isCode,
            "\\bidentityHashCode\\b",
            "int h = System.identityHashCode(this);"),
        call(
            "stack trace on the console",
            "rethrow, or report to LogSink; a bug ends the run with robot, time and seed",
            SourceFile::isCode,
            "\\bprintStackTrace\\b",
            "e.printStackTrace();"),
        call(
            "a value read back from a text that StarL wrote",
            "the value itself: events carry facts, values and messages of their types",
            CodeRules::isMain,
            "\\bargs\\(\\)\\s*\\.\\s*get\\b|\\b(value|message|fact)\\(\\)\\s*\\.\\s*toString\\(\\)\\s*\\."
                + "\\s*(equals|split|startsWith|endsWith|substring|indexOf|matches|contains)\\b",
            "RobotId who = RobotId.of(action.args().get(0));"),
        call(
            "writing to the console",
            "LogSink in a robot, the command's own writer in org.starl.cli",
            CodeRules::isMain,
            "\\bSystem\\s*\\.\\s*(out|err)\\b",
            "System.out.println(1);"),
        new Rule(
            "empty catch",
            "handle the failure as a value, or let it through",
            SourceFile::isCode,
            Rule.acrossLines("\\bcatch\\s*\\([^)]*\\)\\s*\\{\\s*\\}"),
            new SourceFile(CORE, "try {\n  f();\n} catch (Exception e) {\n  // never mind\n}")),
        call(
            "a test that is switched off",
            "mend it or delete it",
            SourceFile::isCode,
            "@Disabled\\b",
            "@Disabled"),
        new Rule(
            "a warning suppressed without a reason",
            "a comment beside or above @SuppressWarnings that says why",
            SourceFile::isCode,
            CodeRules::unexplainedSuppressions,
            new SourceFile(
                CORE, "class A {\n\n  @SuppressWarnings(\"unchecked\")\n  void f() {}\n}")));
  }

  private static Rule call(
      String name, String instead, Predicate<SourceFile> scope, String regex, String wrong) {
    return call(name, instead, scope, regex, CORE, wrong);
  }

  private static Rule call(
      String name,
      String instead,
      Predicate<SourceFile> scope,
      String regex,
      String path,
      String wrong) {
    return new Rule(name, instead, scope, Rule.inCode(regex), new SourceFile(path, wrong));
  }

  private static boolean isMain(SourceFile file) {
    return file.isMain();
  }

  /** Code that runs on robots' strands alone. */
  private static boolean isOnStrand(SourceFile file) {
    return file.isMain()
        && (file.path().startsWith("starl-core/")
            || file.path().startsWith("starl-primitives/")
            || isAppsLogic(file));
  }

  /** Code whose choices show in a trace. */
  private static boolean decides(SourceFile file) {
    return isOnStrand(file) || (file.isMain() && file.path().startsWith("starl-sim/"));
  }

  private static boolean isAppsLogic(SourceFile file) {
    return file.path().matches("starl-apps/.*/org/starl/apps/.*/logic/.*");
  }

  private static List<Integer> unexplainedSuppressions(SourceFile file) {
    List<String> lines = file.lines();
    return Rule.inCode("@SuppressWarnings\\b").apply(file).stream()
        .filter(line -> !lines.get(line - 1).contains("//"))
        .filter(line -> line < 2 || !lines.get(line - 2).strip().matches("//.*|.*\\*/"))
        .toList();
  }
}
