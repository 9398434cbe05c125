from .page import MAX_CONTACTS as MAX_CONTACTS, lab_page as lab_page
