/**
 * Agreement on values. {@link org.starl.primitives.agreement.SetAgreement} agrees on one value, for
 * apps. Below it is the {@link org.starl.primitives.agreement.Synod}, which registration, election and
 * barrier use too: {@link org.starl.primitives.agreement.SynodProtocol} is the base of their
 * protocols, {@link org.starl.primitives.agreement.SynodWire} connects them to a robot. The paper calls
 * the core of its registration "set-valued distributed consensus" (section 4.3); this is that
 * consensus, over bytes.
 *
 * <p>(a) <b>Safety.</b> {@code Agreement}: for one instance and number, at most one value is ever
 * decided, on all robots, for ever. {@code Validity}: the decided value was proposed for that instance
 * and number. Both hold under any loss, delay, duplication, reordering and partition, and whichever
 * robots crash and restart, provided that stable storage keeps what it has flushed. Only progress
 * depends on time.
 *
 * <p>(b) <b>Progress.</b> With message delay δ, a majority of acceptors in reach and one proposer, a
 * decision takes 4δ (prepare 2, accept 2), and other robots hear of it δ later. A ballot asks all
 * acceptors in one step, for promises and then for votes ({@code Asks}). Competing proposers can
 * defeat each other's ballots; growing random pauses make a long series of defeats unlikely. No
 * protocol can guarantee a decision without a bound on delays (Fischer, Lynch, Paterson, "Impossibility
 * of distributed consensus with one faulty process", Journal of the ACM 32(2), 1985): at its deadline a
 * proposer reports {@code failed}, and the value may still be decided later.
 *
 * <p>(c) <b>Assumptions.</b> The acceptors are fixed for the life of an instance. Messages are not
 * forged. No id is used by two proposers ({@link org.starl.Identity#freshProcess}). An acceptor that
 * has lost its stable storage must not take part again.
 *
 * <p>The handlers of {@code Acceptor} and {@code Proposer} are the actions {@code Prepared}, {@code
 * Accept}, {@code Propose} and {@code Learn} of the theory {@code Synod_decls}. Every run of that theory
 * is a run of {@code SetAgreement_decls}, whose safety is proved; {@link
 * org.starl.primitives.agreement.SynodConformance} replays each decree on the first, {@link
 * org.starl.primitives.agreement.AgreementConformance} each run on the second. Wishes in
 * prepare messages are hints: they let one decree serve several proposers, and no safety argument uses
 * them.
 *
 * <p>May import: core, {@code org.starl.primitives}, its {@code exhaustive}.
 */
@NullMarked
package org.starl.primitives.agreement;

import org.jspecify.annotations.NullMarked;
