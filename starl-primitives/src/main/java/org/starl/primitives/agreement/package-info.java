/**
 * Agreement on one value: {@link org.starl.primitives.agreement.SetAgreement} for apps, and the
 * {@link org.starl.primitives.agreement.Synod} under it, on which Registration, Election and Barrier
 * stand as well. The paper calls Registration's core "set-valued distributed consensus" (section
 * 4.3); this is that consensus, over bytes.
 *
 * <p>(a) <b>Safety.</b> {@code Agreement}: for one instance and number, at most one value is ever
 * decided, on all robots, for ever. {@code Validity}: what is decided was proposed for that instance
 * and number. Both hold under any loss, delay, duplication, reordering and partition, and whoever
 * crashes and restarts, provided that stable storage keeps what it has flushed. Time bounds progress
 * only.
 *
 * <p>(b) <b>Progress.</b> With message delay δ, a majority of acceptors in reach and one proposer, a
 * decision takes 4δ (prepare 2, accept 2), and others hear of it δ later. Competing proposers defeat
 * each other's ballots at worst; random pauses that grow make that unlikely to last. No protocol can
 * promise a decision without any bound on delays (Fischer, Lynch, Paterson, "Impossibility of
 * distributed consensus with one faulty process", Journal of the ACM 32(2), 1985): at its deadline a
 * proposer is told {@code failed}, and the value may still be decided later.
 *
 * <p>(c) <b>Assumptions.</b> The acceptors are fixed for the life of an instance. Messages are not
 * forged. No id is used by two proposers ({@link org.starl.Identity#freshProcess}). An acceptor that
 * has lost its stable storage must not take part again.
 *
 * <p>The handlers of {@code Acceptor} and {@code Proposer} realise the actions {@code Prepared},
 * {@code Accept}, {@code Propose} and {@code Learn} of the theory {@code Synod_decls}, every run of
 * which is one of {@code SetAgreement_decls}; {@link
 * org.starl.primitives.agreement.AgreementConformance} takes each run through the automaton of the
 * latter, of which safety is proved. Wishes that ride on prepare messages are hints: they let one
 * decree serve several proposers, and no argument rests on them.
 *
 * <p>May import: core, {@code org.starl.primitives}.
 */
@NullMarked
package org.starl.primitives.agreement;

import org.jspecify.annotations.NullMarked;
