/**
 * Mutual exclusion on sets of sections (paper, section 4.5), by Ricart and Agrawala's algorithm
 * with dynamic membership. {@link org.starl.primitives.mutex.MutexPrim} is the interface for apps,
 * {@link org.starl.primitives.mutex.M_Mutex} the implementation on a robot, {@code MutexProtocol}
 * the pure algorithm, {@link org.starl.primitives.mutex.MutexSpec} this contract as monitors over
 * the trace. {@link org.starl.primitives.mutex.MutexConformance} replays each run on the automaton
 * of the theory {@code Mutex_decls}, whose safety is proved, and {@link
 * org.starl.primitives.mutex.ProtocolConformance} on that of its protocol, {@code MutexProtocol_decls}.
 *
 * <p><b>Contract.</b> Let delta be the time within which a repeated message arrives, and N the
 * number of participants whose consent a participant needs, itself included.
 *
 * <ul>
 *   <li>(a) <b>Safety</b> ({@code Exclusive}; the paper's {@code Inv_mux_safety}): the sections
 *       that two participants hold are always disjoint. All sections of a request are granted at
 *       once; they are released one by one or together.
 *   <li>(b) <b>Progress</b> ({@code Served}): if every holder releases within d1, a request has
 *       access within {@code d2 = (N - 1)(d1 + 2 delta) + 3 delta}, plus one turn for each
 *       participant that joined before it could receive the request. No request starves: they are
 *       served in the order of their logical times. Otherwise {@code failed} becomes true, at the
 *       latest at the deadline.
 *   <li>(c) <b>Non-interference</b> ({@code NonInterference}): while no other participant holds, or
 *       waits with priority for, a section of a request, it has access within {@code d3 = 2 delta}.
 *       So requests without common sections never wait for each other. The paper's condition, that
 *       no other participant <em>holds</em> a section, is not enough: k holds A; j waits for {A,
 *       B}; i requests B later than j, and waits for j, though no participant holds B.
 * </ul>
 *
 * <p>An uncontended request costs 2 (N - 1) messages and 2 delta; a release N - 1 messages: a
 * participant tells those that it has asked what it gives back, in the same step ({@code Tells}). Without
 * loss delta is the longest delay; with loss, add one wait of {@link
 * org.starl.primitives.mutex.MutexTimes} for each message lost in a row.
 *
 * <p><b>Sequences.</b> {@link org.starl.primitives.mutex.PipelinePrim} requests sections one by one, in
 * the order in which the robot passes them; a request holds some while it waits for the next. Safety
 * is (a), as for sets. A participant consents to each section by itself. Requests have one order at
 * all sections, so no circle of them waits. A request is <em>late</em> if its logical time is
 * earlier than that of a participant that holds one of its sections and waits for others. It holds
 * nothing, fails as {@code LATE}, and is made again with a later time. A program that restarts in
 * the middle of its sequence <em>resumes</em> it: it comes before all that wait for its body anyway.
 * While it waits for another body itself, it lets other resumed sequences go first.
 * {@link org.starl.primitives.mutex.PipelineConformance} replays runs on the automaton of the
 * theory {@code Pipeline_decls}. Its proofs cover exclusion of all requests, and the absence of
 * circles for requests that neither are late nor resume. Until a request resumes, runs are replayed on
 * {@code MutexProtocol_decls} as well: exclusion is proved of its messages, too. The order after a restart is tested, not
 * proved; of how long a request waits, or how often it is late, nothing is proved.
 *
 * <p><b>Modes.</b> A section's name may end in a mode and a capacity ({@code aisle/east*2}, see {@link
 * org.starl.primitives.membership.Sections}). Two names <em>exclude</em> each other if they are of one
 * section, and not of one mode; this relation takes the place of equal names in (a), (b) and (c). So a
 * request of an earlier mode is never overtaken. Of a mode with capacity k at most k robots hold the
 * section ({@code Capacity}): an answer may consent and say that its sender is counted, because it
 * holds the section, or comes first. A request enters with fewer than k of these, ghosts included. The
 * later of two requests counts the earlier one. If the order is another one, as of a resumed request,
 * or of a new participant that a holder did not ask, the two exclude each other. A resumed robot keeps
 * its place where its body is. {@link org.starl.primitives.mutex.ModesConformance} replays runs on
 * the automaton of the theory {@code Modes_decls}, whose proofs cover exclusion and capacity of sets
 * and sequences, not the order.
 *
 * <p><b>Envelope.</b> Safety holds under every loss, delay, duplication, reordering and partition,
 * under all crashes and restarts, and for right and wrong suspicions; it depends on no clock.
 * Messages are not forged (a message in another robot's name is dropped). With dynamic membership,
 * safety depends on the views of {@link org.starl.primitives.membership.Membership}: equal numbers
 * mean equal lists; a list contains all participants admitted before that have neither left nor
 * been confined; a removed participant is not admitted again; only an idle participant leaves. Then
 * of any two participants with open requests one needs the other's consent ({@code Connected}), and
 * consent is a promise to come later ({@code Promise}).
 *
 * <p><b>Crash: confinement.</b> A participant that waits for f, and receives nothing from f for Ts,
 * asks all participants for a <em>fence</em>: a promise never to grant f anything again, and the
 * part of f's newest request that f may still hold with the fencer's consent. A fence counts only
 * if f needs the fencer's consent to enter: the fencer is listed wherever f is (it is as old as f
 * or older), or f has asked it. The intersection of the fences bounds all that f holds or ever will
 * ({@code Kept}), and a view confines f to it. Participants that learn this view no longer need f's
 * answer. Requests that overlap the bound soon fail as {@code OCCUPIED}, so that requests behind
 * them do not wait as well; all others continue.
 *
 * <p>Confinement needs a view: two participants that suspect each other may both send fences, but
 * views are ordered, and f can stop needing its fencer only by a view that lists f and not the
 * fencer. A fence counts only while its fencer is listed. The ghost of f shrinks when fencers learn
 * a smaller bound, when f releases its sections, and when the next start of its robot declares its
 * place ({@code standsIn}). A wrongly suspected participant is told ({@code FENCED} or {@code
 * REMOVED}), keeps its sections until it releases them, and registers again.
 *
 * <p>After a crash, a request that waited for the crashed participant has access after Ts + 9 delta
 * more, if a majority of the registration's acceptors is in reach and no ghost overlaps it.
 *
 * <p><b>Differences from the theory.</b> {@code Noted}: a participant that defers an answer says so
 * when the request is repeated; this replaces the link's acknowledgement and grants nothing. A
 * participant that knows a smaller bound for a ghost than the view fences it and proposes this
 * bound without a question. A ghost in the latest view is granted nothing, as if the grant were
 * lost. A retired id keeps its fences.
 *
 * <p><b>Limits.</b> If all participants whose consent a crashed one needed are gone, too (it was
 * alone, or the others left), no participant knows what it holds. Then requests that need its
 * answer fail at their deadline until its robot restarts and declares its place. A closed group
 * never confines a member, for the same reason. Requesting in one instance while holding in another
 * can deadlock until the deadline: use one instance, or the same order of requests everywhere. One
 * mutex depends on one registration.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code exhaustive}, {@code membership} and
 * {@code suspicion}.
 */
@NullMarked
package org.starl.primitives.mutex;

import org.jspecify.annotations.NullMarked;
