------------------------------ MODULE Sessions ------------------------------
(* The exchange of starts between two robots A and B, whose machines crash,    *)
(* lose their storage or run with a copied one, on a network that belongs to   *)
(* an attacker without keys. The names in brackets are those of the Java       *)
(* classes of org.starl.robot.udp and org.starl.session.                       *)
(*                                                                             *)
(* The cryptography is perfect: only a machine of a robot signs and seals as   *)
(* that robot, and a nonce cannot be guessed before it is drawn. Beacons that  *)
(* are not signed do not appear. An attacker can forge them, and so make each  *)
(* running machine echo any nonce that was drawn [UNPROVEN]. Here each machine *)
(* echoes the nonce of each running program as soon as both run: the attacker  *)
(* delivers the echo at any time later, and any number of times.               *)
(*                                                                             *)
(* Not modelled: addresses, the counts of beacons and datagrams, replacement   *)
(* of keys, robots without keys.                                               *)
EXTENDS Naturals, Sequences, TLC

CONSTANTS
  MachinesOfA, MachinesOfB,  \* more than one: some are second machines of that robot
  MaxStarts,     \* of all machines together
  MaxLosses,     \* how often a machine loses its storage
  MaxCopies      \* how often a storage is copied over that of a second machine

VARIABLES
  disk,       \* the stable storage of each machine
  proc,       \* the program on each machine
  beacons,    \* all signed beacons that were ever sent
  datagrams,  \* all datagrams that were ever sealed
  drawn,      \* number of nonces drawn; they are 1, 2, ...
  losses, copies,
  disturbed   \* robots that lost or copied a storage, or started on two machines

vars == <<disk, proc, beacons, datagrams, drawn, losses, copies, disturbed>>

Machines == MachinesOfA \cup MachinesOfB
Alike == Permutations(MachinesOfA) \cup Permutations(MachinesOfB)

RobotOf(m) == IF m \in MachinesOfA THEN "A" ELSE "B"
Peer(m) == IF RobotOf(m) = "A" THEN "B" ELSE "A"

NoNonce == 0
NoStart == [epoch |-> 0, boot |-> 0, nonce |-> NoNonce]

\* latest: the peer's [LatestStarts]. opened: history only, the starts of the peer with
\* which a program with this storage has opened sessions; copied with the storage.
NewDisk(epoch) == [epoch |-> epoch, boots |-> 0, latest |-> NoStart, opened |-> <<>>]

\* heard: the peer's latest start [Neighbour.start]; isProven: heard by this program, not
\* only read; posted, flushed: to be written, and then to be opened [Discovery.started].
Program(start, heard) ==
  [start |-> start, heard |-> heard, isProven |-> FALSE, posted |-> <<>>,
   flushed |-> <<>>, session |-> NoStart]
Off == Program(NoStart, NoStart)

Runs(m) == proc[m].start # NoStart

Beacon(m, start, to, echo, answer) ==
  [robot |-> RobotOf(m), start |-> start, to |-> to, echo |-> echo, answer |-> answer]

\* The keys of one direction of a session [Session]: of both starts.
Key(sender, receiver) == <<sender, receiver>>

\* A second machine has a copy of the first one's storage, from before the first start.
Init ==
  /\ disk = [m \in Machines |-> NewDisk(IF RobotOf(m) = "A" THEN 1 ELSE 2)]
  /\ proc = [m \in Machines |-> Off]
  /\ beacons = {} /\ datagrams = {}
  /\ drawn = 0 /\ losses = 0 /\ copies = 0
  /\ disturbed = {}

-----------------------------------------------------------------------------
\* The program starts, after a crash at any point [Discovery.begin].
Start(m) ==
  LET nonce == drawn + 1
      start == [epoch |-> disk[m].epoch, boot |-> disk[m].boots + 1, nonce |-> nonce]
      latest == disk[m].latest
      others == {x \in Machines \ {m} : Runs(x)}
      twins == {x \in Machines \ {m} : RobotOf(x) = RobotOf(m) /\ disk[x].boots > 0}
  IN /\ drawn < MaxStarts
     /\ drawn' = nonce
     /\ disk' = [disk EXCEPT ![m].boots = @ + 1]
     /\ proc' = [proc EXCEPT ![m] = Program(start, latest)]
     /\ beacons' = beacons
          \cup {Beacon(x, proc[x].start, RobotOf(m), nonce, "ACCEPTED") : x \in others}
          \cup {Beacon(m, start, RobotOf(x), proc[x].start.nonce, "ACCEPTED") : x \in others}
     /\ disturbed' = IF twins = {} THEN disturbed ELSE disturbed \cup {RobotOf(m)}
     /\ UNCHANGED <<datagrams, losses, copies>>

\* Machine m has an empty storage from now on, with a new epoch [StorageEpoch.ofOrNew].
LoseStorage(m) ==
  /\ losses < MaxLosses
  /\ losses' = losses + 1
  /\ disk' = [disk EXCEPT ![m] = NewDisk(3 + losses)]
  /\ proc' = [proc EXCEPT ![m] = Off]
  /\ disturbed' = disturbed \cup {RobotOf(m)}
  /\ UNCHANGED <<beacons, datagrams, drawn, copies>>

\* A second machine gets the storage of machine m; or a backup is brought back.
CopyStorage(m, to) ==
  /\ copies < MaxCopies /\ m # to /\ RobotOf(m) = RobotOf(to) /\ disk[m] # disk[to]
  /\ copies' = copies + 1
  /\ disk' = [disk EXCEPT ![to] = disk[m]]
  /\ proc' = [proc EXCEPT ![to] = Off]
  /\ disturbed' = disturbed \cup {RobotOf(m)}
  /\ UNCHANGED <<beacons, datagrams, drawn, losses>>

-----------------------------------------------------------------------------
\* Neighbours.answerTo
Answer(m, start) ==
  LET latest == proc[m].heard
  IN CASE latest = NoStart \/ start = latest -> "ACCEPTED"
       [] start.epoch # latest.epoch -> "OTHER_STORAGE"
       [] start.boot > latest.boot -> "ACCEPTED"
       [] OTHER -> "LATER_START"

\* The beacon contains the nonce of this start of the program [Neighbours.hear].
IsFresh(m, b) ==
  /\ Runs(m)
  /\ b.to = RobotOf(m)
  /\ b.echo = proc[m].start.nonce
  /\ b.start.nonce # proc[m].start.nonce

\* TWIN or REFUSES_US: the beacon stops the program. Here the program goes on after it,
\* since the end of the Java program is asynchronous. A refusal by a machine that this one
\* refuses too stops it only if no third robot accepts it; here there is no third robot.
Stops(m, b) ==
  /\ IsFresh(m, b)
  /\ \/ b.robot = RobotOf(m)
     \/ b.answer # "ACCEPTED"

\* Discovery.refuse
Refuse(m, b) ==
  /\ IsFresh(m, b) /\ b.robot = Peer(m)
  /\ b.answer = "ACCEPTED" /\ Answer(m, b.start) # "ACCEPTED"
  /\ beacons' = beacons \cup
       {Beacon(m, proc[m].start, Peer(m), b.start.nonce, Answer(m, b.start))}
  /\ UNCHANGED <<disk, proc, datagrams, drawn, losses, copies, disturbed>>

\* Neighbours.heardFresh: STARTED, REFUSES_US, or HEARD, which changes nothing here.
HearFresh(m, b) ==
  LET isNew == b.start # proc[m].heard \/ ~proc[m].isProven
      isAccepted == b.answer = "ACCEPTED"
  IN /\ IsFresh(m, b) /\ b.robot = Peer(m) /\ Answer(m, b.start) = "ACCEPTED"
     /\ proc' = [proc EXCEPT
          ![m].heard = b.start,
          ![m].isProven = TRUE,
          ![m].posted = IF isNew /\ isAccepted THEN Append(@, b.start) ELSE @]
     /\ UNCHANGED <<disk, beacons, datagrams, drawn, losses, copies, disturbed>>

\* LatestStarts.put
Write(m) ==
  /\ proc[m].posted # <<>>
  /\ LET start == Head(proc[m].posted)
     IN /\ disk' = [disk EXCEPT ![m].latest = start]
        /\ proc' = [proc EXCEPT ![m].posted = Tail(@), ![m].flushed = Append(@, start)]
  /\ UNCHANGED <<beacons, datagrams, drawn, losses, copies, disturbed>>

\* OpenSessions.open; the program seals a datagram for its peer at once [Session.seal].
Open(m) ==
  /\ proc[m].flushed # <<>>
  /\ LET start == Head(proc[m].flushed)
     IN /\ proc' = [proc EXCEPT ![m].flushed = Tail(@), ![m].session = start]
        /\ disk' = [disk EXCEPT ![m].opened = Append(@, start)]
        /\ datagrams' = datagrams \cup
             {[robot |-> RobotOf(m), from |-> proc[m].start, to |-> start,
               key |-> Key(proc[m].start, start)]}
  /\ UNCHANGED <<beacons, drawn, losses, copies, disturbed>>

Next ==
  \/ \E m \in Machines : Start(m) \/ LoseStorage(m) \/ Write(m) \/ Open(m)
  \/ \E m, to \in Machines : CopyStorage(m, to)
  \/ \E m \in Machines, b \in beacons : Refuse(m, b) \/ HearFresh(m, b)

Spec == Init /\ [][Next]_vars

-----------------------------------------------------------------------------
\* Session.open: a datagram may be delivered at any time; only its key counts.
Accepts(m, d) ==
  /\ proc[m].session # NoStart
  /\ d.key = Key(proc[m].session, proc[m].start)

\* An accepted datagram is of a start of the peer that had a session with exactly this start.
NoOldDatagram ==
  \A m \in Machines, d \in datagrams :
    Accepts(m, d) =>
      d.robot = Peer(m) /\ d.from = proc[m].session /\ d.to = proc[m].start

\* The sessions opened with one storage never go back to an earlier start of the peer, and no
\* two of them are with starts of one boot number: those are on two machines.
OrderedSessions ==
  \A m \in Machines :
    LET opened == disk[m].opened
    IN \A i, j \in 1..Len(opened) : i < j =>
         opened[i].boot < opened[j].boot \/ opened[i] = opened[j]

\* All sessions opened with one storage are with one storage of the peer.
OneStorage ==
  \A m \in Machines :
    LET opened == disk[m].opened
    IN \A i \in 1..Len(opened) : opened[i].epoch = opened[1].epoch

\* No recording stops a robot.
NoStopSwitch ==
  \A m \in Machines, b \in beacons : Stops(m, b) => RobotOf(m) \in disturbed

=============================================================================
