! Solves a deck: the name of its file is the first argument.
!
!   gfortran -std=f2008 port/fortran/contact2d.f90 examples/fortran/contact.f90 build/libcontact2d.a -o contact
!   ./contact examples/hertz.dat
!
! The cards come through a Fortran unit, the workspace and the blocks are allocatable arrays, and every increment calls
! a Fortran function. The constants with a kind make it independent of the compiler's default kinds.
module callbacks
  use contact2d
  implicit none
  private
  public :: next_card, show_step, tell
contains

  ! The next card of the unit that `context` points to, and its length; -1 at the end of the deck.
  function next_card(context, text, size) bind(C) result(length)
    type(c_ptr), value :: context
    integer(c_int32_t), value :: size
    character(kind=c_char), intent(inout) :: text(size)
    integer(c_int32_t) :: length
    integer(c_int32_t), pointer :: unit
    character(1000) :: card
    integer :: status
    call c_f_pointer(context, unit)
    read (unit, '(a)', iostat=status) card
    if (status < 0) then
      length = -1
    else if (status > 0) then
      length = -2
    else
      length = len_trim(card, c_int32_t)
      call c2d_set_string(text, trim(card))
    end if
  end function

  ! The largest pressure of all pairs at the end of an increment.
  function show_step(context, step) bind(C) result(stop)
    type(c_ptr), value :: context
    type(c2d_step), intent(in) :: step
    integer(c_int32_t) :: stop
    real(c_double), pointer :: table(:, :)
    stop = 0
    if (c_associated(context)) stop = 1 ! none was given to c2d_run
    if (step%kind == C2D_STEP_STOPPED) print '(2a)', 'the path ended: ', c2d_outcome_message(step%outcome)
    call c_f_pointer(step%table, table, [step%stride, int(step%pairs, c_int64_t)])
    print '(a,f7.4,a,i4,a,f9.5,a,f18.10)', 'mu ', step%mu, '  step ', step%step, '  load ', step%load, &
        '  peak pressure ', maxval(table(C2D_TN + 1, :))
  end function

  ! Every fault and every warning. The context is the block store's.
  subroutine tell(context, entry) bind(C)
    type(c_ptr), value :: context
    type(c2d_error), intent(in) :: entry
    if (c_associated(context) .and. entry%severity == C2D_FAULT) &
        print '(a,i0,2a)', 'line ', entry%line, ': ', c2d_string(entry%text)
  end subroutine

end module callbacks

program contact
  use contact2d
  use callbacks
  implicit none
  real(c_double), allocatable, target :: memory(:), blocks(:)
  type(c2d_limits) :: limits
  type(c2d_body_limits), target :: bodies(2)
  type(c2d_port) :: port
  type(c2d_error) :: why
  type(c2d_summary) :: summary
  type(c2d_memory_store), target :: store
  type(c_ptr) :: solver
  integer(c_int32_t), target :: unit
  integer(c_int64_t) :: minimum, in_core
  character(1000) :: deck, reason
  integer :: status

  if (command_argument_count() /= 1) call refuse('usage: contact DECK')
  call get_command_argument(1, deck)
  open (newunit=unit, file=trim(deck), status='old', action='read', iostat=status, iomsg=reason)
  if (status /= 0) call refuse('contact: ' // trim(reason))
  limits%bodies = 2
  limits%body = c_loc(bodies)
  call check(c2d_scan_deck(c_funloc(next_card), c_loc(unit), limits, why), 'deck')
  rewind (unit)

  call check(c2d_memory_need(limits, minimum, in_core, why), 'sizes')
  allocate (memory((in_core + 7) / 8), blocks(2 * in_core / 8))
  call c2d_memory_store_init(store, c_loc(blocks), 8_c_int64_t * size(blocks, kind=c_int64_t))
  call c2d_memory_store_port(store, port)
  port%log = c_funloc(tell)
  call check(c2d_create(solver, c_loc(memory), 8_c_size_t * size(memory, kind=c_size_t), limits, port, why), 'memory')

  call check(c2d_read_deck(solver, c_funloc(next_card), c_loc(unit)), 'deck')
  call check(c2d_prepare(solver), 'prepare')
  call check(c2d_run(solver, c_funloc(show_step), c_null_ptr), 'run')
  call check(c2d_get_summary(solver, summary), 'summary')
  print '(4a,i0,a)', c2d_string(summary%title), ': ', c2d_outcome_message(summary%outcome), ', ', &
      summary%peak_bytes, ' bytes used'
  call check(c2d_close(solver), 'close')
  close (unit)

contains

  subroutine refuse(text)
    character(*), intent(in) :: text
    print '(a)', text
    stop 1
  end subroutine

  subroutine check(status, what)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: what
    if (status == C2D_OK) return
    print '(4a)', what, ': ', c2d_message(status), '. ' // c2d_string(why%text)
    stop 1
  end subroutine

end program contact
