package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.starl.gvh.Trace;
import org.starl.id.ProcessId;
import org.starl.primitives.Phases;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.trace.TraceEvent;

/**
 * How a mutex appears in a trace: actions of source {@code mutex/xid}, with these arguments.
 *
 * <pre>
 * do_mutex  who num ts sections known
 * od_mutex  who num sections
 * release   who num given left
 * withdraw  who num why
 * grant     who to num
 * known     who num known
 * view      who view
 * fence     who suspect open
 * stands_in who sections
 * </pre>
 *
 * Sections and participants are sorted names, separated by single spaces; a view has the format of
 * {@link View#toString}.
 */
public final class MutexTrace {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "mutex";

  private static final String DO_MUTEX = "do_mutex";
  private static final String OD_MUTEX = "od_mutex";
  private static final String RELEASE = "release";
  private static final String WITHDRAW = "withdraw";
  private static final String GRANT = "grant";
  private static final String KNOWN = "known";
  private static final String VIEW = "view";
  private static final String FENCE = "fence";
  private static final String STANDS_IN = "stands_in";

  /** The phases of {@link MutexProtocol.Phase}, for all ids of a robot's program together. */
  public static final Phases PHASES =
      Phases.of(PRIMITIVE, MutexMessage.class, () -> MutexTrace::phase, (Object[]) Phase.values());

  private MutexTrace() {}

  private static String phase(String before, String name, List<String> texts) {
    return switch (name) {
      case DO_MUTEX -> Phase.TRYING.name();
      case OD_MUTEX -> Phase.CRITICAL.name();
      case WITHDRAW -> Phase.IDLE.name();
      case RELEASE -> texts.get(3).isEmpty() ? Phase.IDLE.name() : before;
      default -> before;
    };
  }

  /** The source of instance {@code xid}: {@code mutex/crossing}. */
  public static String source(String xid) {
    return PRIMITIVE + "/" + xid;
  }

  static void write(Trace trace, String source, MutexEvent event) {
    List<String> args = args(event);
    trace.action(source, name(event), args.toArray());
  }

  /**
   * Reads an event of any mutex; empty for other events.
   *
   * @throws IllegalArgumentException if the arguments of a mutex's action are not as above
   */
  public static Optional<MutexEvent> read(TraceEvent event) {
    return event instanceof TraceEvent.Action action && isMutex(action.source())
        ? Optional.of(read(action))
        : Optional.empty();
  }

  /** Whether {@code source} is a mutex, as in {@code mutex/crossing}. */
  static boolean isMutex(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }

  /** Whether a mutex's action concerns requests and access, and not the agreement protocol. */
  public static boolean isOfAccess(TraceEvent.Action action) {
    return switch (action.name()) {
      case DO_MUTEX, OD_MUTEX, RELEASE, WITHDRAW, STANDS_IN -> true;
      default -> false;
    };
  }

  static String name(MutexEvent event) {
    return switch (event) {
      case MutexEvent.DoMutex e -> DO_MUTEX;
      case MutexEvent.OdMutex e -> OD_MUTEX;
      case MutexEvent.Release e -> RELEASE;
      case MutexEvent.Withdraw e -> WITHDRAW;
      case MutexEvent.Grant e -> GRANT;
      case MutexEvent.Known e -> KNOWN;
      case MutexEvent.Learned e -> VIEW;
      case MutexEvent.Fence e -> FENCE;
      case MutexEvent.StandsIn e -> STANDS_IN;
    };
  }

  static List<String> args(MutexEvent event) {
    String who = event.who().toString();
    return switch (event) {
      case MutexEvent.DoMutex e ->
          List.of(who, text(e.num()), text(e.ts()), text(e.want()), text(e.known()));
      case MutexEvent.OdMutex e -> List.of(who, text(e.num()), text(e.held()));
      case MutexEvent.Release e -> List.of(who, text(e.num()), text(e.given()), text(e.left()));
      case MutexEvent.Withdraw e -> List.of(who, text(e.num()), e.why().name());
      case MutexEvent.Grant e -> List.of(who, e.to().toString(), text(e.num()));
      case MutexEvent.Known e -> List.of(who, text(e.num()), text(e.known()));
      case MutexEvent.Learned e -> List.of(who, e.view().toString());
      case MutexEvent.Fence e -> List.of(who, e.suspect().toString(), text(e.open()));
      case MutexEvent.StandsIn e -> List.of(who, text(e.sections()));
    };
  }

  private static MutexEvent read(TraceEvent.Action action) {
    List<String> args = action.args();
    try {
      ProcessId who = ProcessId.parse(args.get(0));
      return switch (action.name()) {
        case DO_MUTEX ->
            new MutexEvent.DoMutex(
                who, number(args, 1), number(args, 2), sections(args, 3), processes(args, 4));
        case OD_MUTEX -> new MutexEvent.OdMutex(who, number(args, 1), sections(args, 2));
        case RELEASE ->
            new MutexEvent.Release(who, number(args, 1), sections(args, 2), sections(args, 3));
        case WITHDRAW ->
            new MutexEvent.Withdraw(who, number(args, 1), MutexFailure.valueOf(args.get(2)));
        case GRANT -> new MutexEvent.Grant(who, ProcessId.parse(args.get(1)), number(args, 2));
        case KNOWN -> new MutexEvent.Known(who, number(args, 1), processes(args, 2));
        case VIEW -> new MutexEvent.Learned(who, View.parse(args.get(1)));
        case FENCE -> new MutexEvent.Fence(who, ProcessId.parse(args.get(1)), sections(args, 2));
        case STANDS_IN -> new MutexEvent.StandsIn(who, sections(args, 1));
        default -> throw new IllegalArgumentException("unknown action");
      };
    } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
      throw new IllegalArgumentException(
          action.source() + " " + action.name() + " " + args + ": no event of a mutex", e);
    }
  }

  private static String text(long number) {
    return Long.toString(number);
  }

  private static String text(Collection<?> names) {
    return names.stream().map(Object::toString).collect(Collectors.joining(" "));
  }

  private static long number(List<String> args, int at) {
    return Long.parseLong(args.get(at));
  }

  private static SortedSet<String> sections(List<String> args, int at) {
    return Sections.copyOf(names(args.get(at), Function.identity()));
  }

  private static SortedSet<ProcessId> processes(List<String> args, int at) {
    return Collections.unmodifiableSortedSet(names(args.get(at), ProcessId::parse));
  }

  private static <T extends Comparable<T>> TreeSet<T> names(
      String line, Function<String, T> toName) {
    TreeSet<T> names = new TreeSet<>();
    int from = 0;
    while (from < line.length()) {
      int space = line.indexOf(' ', from);
      int end = space < 0 ? line.length() : space;
      names.add(toName.apply(line.substring(from, end)));
      from = end + 1;
    }
    return names;
  }
}
