package org.starl.primitives.mutex;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Fence;
import org.starl.primitives.mutex.MutexMessage.FenceQ;
import org.starl.primitives.mutex.MutexMessage.Fenced;
import org.starl.primitives.mutex.MutexMessage.Noted;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.Monitor.Report;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * Checks that requests are answered at once. A process that neither holds nor waits for a section consents in
 * the step in which it is asked, or in which its own request ends. A process that defers an answer says so when
 * the request is repeated, and none consents to a request that it knows to be over. A request ends as late
 * only in a step in which its process hears of one that goes first. Nothing of this is required of a
 * process whose robot may stand in sections of an earlier one. Earlier processes of a program answer, too: one that
 * holds sections like any other, one that has ended with its consent. A process that is asked for a fence,
 * and wants sections, gives it at once. A process asks all that it knows in one step, and tells those that it
 * has asked, in the same step, what it gives back, and that it no longer waits.
 */
final class AnswerCheck {

  /** What one process knows of others' requests, and whether it has one itself. */
  private static final class Participant {
    private View view = View.NONE;
    private long num;
    private long overtakenNs = -1;
    private boolean isTrying;
    private boolean holds;
    private final Map<ProcessId, Req> asked = new TreeMap<>();
    private final Map<ProcessId, Long> asks = new TreeMap<>(); // the numbers of its latest requests
    // The numbers of others' latest requests that have this one's whole consent, and that have
    // ended.
    private final Map<ProcessId, Long> granted = new TreeMap<>();
    private final Map<ProcessId, Long> ended = new TreeMap<>();
    private final Set<ProcessId> fenced = new TreeSet<>();

    private boolean wants() {
      return isTrying || holds;
    }

    private boolean refuses(ProcessId other) {
      return fenced.contains(other) || view.ghost(other) != null;
    }

    private boolean isOwedConsent(ProcessId other, long num) {
      return num > granted.getOrDefault(other, 0L)
          && !hasEnded(other, num)
          && view.contains(other)
          && !refuses(other);
    }

    private boolean hasEnded(ProcessId other, long num) {
      return num <= ended.getOrDefault(other, 0L);
    }
  }

  private final TellCheck answers = new TellCheck(ConsentSpec.ANSWERED);
  private final TellCheck ends = new TellCheck(ConsentSpec.TELLS);
  private final Map<Instance, Map<ProcessId, Participant>> participants = new LinkedHashMap<>();
  private final Map<ProcessKey, ProcessId> newest = new LinkedHashMap<>();
  private final Set<ProcessKey> standing = new LinkedHashSet<>();

  AnswerCheck() {
    answers.begin();
    ends.begin();
  }

  void observe(TraceEvent event, Report report) {
    answers.observe(event, report);
    ends.observe(event, report);
    switch (event) {
      case Action action when action.fact() instanceof MutexFact fact ->
          acted(action, fact, report);
      case Delivered got when got.message() instanceof Noted noted -> {
        Participant participant = of(got.channel(), noted.to());
        if (noted.num() == participant.num && noted.ahead() > 0) {
          participant.overtakenNs = got.timeNs();
        }
      }
      case Delivered got when got.message() instanceof Req req -> asked(got, req);
      case Delivered got when got.message() instanceof FenceQ question -> asked(got, question);
      case Delivered got when got.message() instanceof Rem rem && rem.left().isEmpty() ->
          of(got.channel(), rem.to()).ended.merge(rem.from(), rem.num(), Math::max);
      case Sent sent when sent.message() instanceof Ok ok -> consented(sent, ok, report);
      case Sent sent when sent.message() instanceof Req req ->
          of(sent.channel(), req.from()).asks.put(req.to(), req.num());
      case Sent sent when sent.message() instanceof FenceQ question -> asks(sent, question);
      case Fault fault when fault.name().equals(Fault.CRASH) -> ended(fault.robot());
      case TraceEvent.Left left -> ended(left.robot());
      default -> {}
    }
  }

  private Participant of(Instance source, ProcessId id) {
    return participants
        .computeIfAbsent(source, any -> new TreeMap<>())
        .computeIfAbsent(id, any -> new Participant());
  }

  private void consented(Sent sent, Ok ok, Report report) {
    Participant by = of(sent.channel(), ok.from());
    Req latest = by.asked.get(ok.to());
    boolean isOver = by.hasEnded(ok.to(), ok.num()) || (latest != null && ok.num() < latest.num());
    // Earlier processes of a robot consent to all, and who has left is forgotten.
    boolean isKnown =
        by.view.contains(ok.to())
            && ok.from().equals(newest.get(new ProcessKey(sent.channel(), sent.robot())));
    if (isOver && isKnown) {
      String detail = ok + ": a consent to a request that it knows to be over";
      report.violated(ConsentSpec.ANSWERED, sent.timeNs(), List.of(sent.robot()), detail);
    }
    if (ok.isWhole()) {
      by.granted.merge(ok.to(), ok.num(), Math::max);
    }
  }

  private void ended(RobotId robot) {
    participants.values().forEach(each -> each.keySet().removeIf(id -> id.robot().equals(robot)));
    newest.keySet().removeIf(key -> key.robot().equals(robot));
  }

  private void acted(Action action, MutexFact fact, Report report) {
    Participant participant = of(action.source(), fact.who());
    ProcessKey key = new ProcessKey(action.source(), action.robot());
    switch (fact) {
      case MutexFact.Learned learned -> {
        View view = learned.view();
        participant.view = view;
        // Who has left is forgotten: a late request of it is a first one.
        participant
            .asked
            .values()
            .removeIf(req -> req.admittedBy() <= view.number() && !view.mentions(req.from()));
        ProcessId before = newest.put(key, learned.who());
        if (before != null
            && !before.equals(learned.who())
            && of(action.source(), before).wants()) {
          standing.add(key); // it takes over what that one has
        }
      }
      case MutexFact.StandsIn place -> {
        if (place.sections().isEmpty()) {
          standing.remove(key);
        } else {
          standing.add(key);
        }
      }
      case MutexFact.DoMutex request -> {
        participant.num = request.num();
        participant.isTrying = true;
        for (ProcessId other : request.known()) {
          mustAsk(
              action,
              other,
              told ->
                  told instanceof Req req && req.to().equals(other) && req.num() == request.num());
        }
      }
      case MutexFact.OdMutex access -> {
        report.checked(ConsentSpec.LATE);
        participant.holds = true;
      }
      case MutexFact.Fence fence -> participant.fenced.add(fence.suspect());
      case MutexFact.Release release -> {
        participant.holds = !release.left().isEmpty();
        participant.isTrying &= participant.holds;
        mustTell(action, participant, release.num(), release.given());
        mayEnd(action, participant, fact.who(), key);
      }
      case MutexFact.Withdraw end -> {
        report.checked(ConsentSpec.LATE);
        if (end.why() == MutexFailure.LATE && participant.overtakenNs != action.timeNs()) {
          String detail =
              fact.who() + "'s request " + end.num() + ": no request was told to be ahead";
          report.violated(ConsentSpec.LATE, action.timeNs(), List.of(action.robot()), detail);
        }
        participant.isTrying = false;
        mustTell(action, participant, end.num(), Sections.NONE);
        mayEnd(action, participant, fact.who(), key);
      }
      default -> {}
    }
  }

  private void mustTell(Action action, Participant participant, long num, SortedSet<String> given) {
    participant.asks.forEach((other, asked) -> {
      if (asked == num) {
        ends.owes(
            action,
            other.robot().name(),
            other + " that request " + num + " ends",
            told ->
                told instanceof Rem rem
                    && rem.to().equals(other)
                    && rem.num() == num
                    && !Sections.meet(rem.left(), given));
      }
    });
  }

  /** A question for a fence is for all. */
  private void asks(Sent sent, FenceQ question) {
    for (ProcessId other : of(sent.channel(), question.from()).view.ids()) {
      if (!other.equals(question.from()) && !other.equals(question.suspect())) {
        mustAsk(
            sent,
            other,
            told ->
                told instanceof FenceQ same
                    && same.to().equals(other)
                    && same.suspect().equals(question.suspect()));
      }
    }
  }

  private void mustAsk(TraceEvent event, ProcessId other, Predicate<Object> accepts) {
    ends.owes(event, other.robot().name(), "what it asks, for " + other, accepts);
  }

  private void mayEnd(Action action, Participant participant, ProcessId me, ProcessKey key) {
    if (participant.wants() || standing.contains(key) || !me.equals(newest.get(key))) {
      return;
    }
    participant.asked.forEach((other, req) -> {
      if (participant.isOwedConsent(other, req.num())) {
        owes(action, req, told -> told instanceof Ok ok && answers(ok, req) && ok.isWhole());
      }
    });
  }

  private void asked(Delivered got, Req req) {
    ProcessKey key = new ProcessKey(got.channel(), got.robot());
    Participant participant = of(got.channel(), req.to());
    Req before = participant.asked.get(req.from());
    boolean isForged = !req.from().robot().equals(got.from());
    boolean isStale =
        participant.hasEnded(req.from(), req.num()) || (before != null && req.num() < before.num());
    boolean isOfThisProgram = participant.view.number() > 0;
    if (isForged || isStale || !isOfThisProgram) {
      return;
    }
    participant.asked.put(req.from(), req);
    if (req.resumes()) {
      participant.overtakenNs = got.timeNs();
    }
    boolean isRetired = !req.to().equals(newest.get(key)) && !participant.wants();
    if (isRetired) {
      if (!participant.fenced.contains(req.from())) { // a fence outlasts its process
        owes(got, req, told -> told instanceof Ok ok && answers(ok, req) && ok.isWhole());
      }
    } else if (participant.refuses(req.from())) {
      owes(got, req, told -> told instanceof Fenced || (told instanceof Ok ok && answers(ok, req)));
    } else if (!participant.wants() && !standing.contains(key)) {
      owes(got, req, told -> told instanceof Ok ok && answers(ok, req) && ok.isWhole());
    } else if (req.equals(before)) {
      owes(
          got,
          req,
          told ->
              (told instanceof Ok ok && answers(ok, req))
                  || (told instanceof Noted noted && noted.num() == req.num()));
    }
  }

  /** A process that holds or waits does not leave: so it answers if the suspect needs its consent. */
  private void asked(Delivered got, FenceQ question) {
    ProcessId me = question.to();
    ProcessId suspect = question.suspect();
    Participant participant = of(got.channel(), me);
    View view = participant.view;
    if (question.from().robot().equals(got.from())
        && participant.wants()
        && !suspect.equals(me)
        && view.contains(me)
        && view.admittedBy(me) <= question.admittedBy()) {
      answers.owes(
          got,
          question.from().robot().name(),
          "a fence of " + suspect,
          told ->
              told instanceof Fence fence
                  && fence.to().equals(question.from())
                  && fence.suspect().equals(suspect));
    }
  }

  private static boolean answers(Ok ok, Req req) {
    return ok.from().equals(req.to()) && ok.to().equals(req.from()) && ok.num() == req.num();
  }

  private void owes(TraceEvent event, Req req, Predicate<Object> accepts) {
    String what = "an answer to request " + req.num() + " of " + req.from();
    answers.owes(event, req.from().robot().name(), what, accepts);
  }
}
